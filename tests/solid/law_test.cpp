// Laws that the program does not include: Saint Venant–Kirchhoff, and damage with an internal variable. Kernels for any
// law compared with those of laws that have their own.
#include "solid/archive.hpp"
#include "solid/many_bodies.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::solid {
namespace law_test {

using namespace test;

/// W = λ/2 (tr E)² + μ E:E with E = (FᵀF − I)/2, P = F S with S = λ tr E I + 2μ E.
struct SaintVenantKirchhoff : ElasticConstants {
  static constexpr auto name = "Saint Venant–Kirchhoff";
  static constexpr bool linear = false;

  static Mat<3> strain(const Mat<3>& f) { return 0.5 * (f.transpose() * f - Mat<3>::Identity()); }
  Mat<3> second_piola_stress(const Mat<3>& f) const {
    return lambda * strain(f).trace() * Mat<3>::Identity() + 2 * mu * strain(f);
  }
  double energy(const Mat<3>& f) const { return 0.5 * second_piola_stress(f).cwiseProduct(strain(f)).sum(); }
  Mat<3> stress(const Mat<3>& f) const { return f * second_piola_stress(f); }
  Moduli moduli(const Mat<3>& f) const {
    const Mat<3> s = second_piola_stress(f), left = f * f.transpose();
    // ∂P_ik/∂F_jl = δ_ij S_kl + λ F_ik F_jl + μ ((F Fᵀ)_ij δ_kl + F_il F_jk)
    return moduli_of([&](int i, int k, int j, int l) {
      return (i == j) * s(k, l) + lambda * f(i, k) * f(j, l) + mu * ((k == l) * left(i, j) + f(i, l) * f(j, k));
    });
  }
};

/// Saint Venant–Kirchhoff with softening: P = e^{−κ} ∂W/∂F, where κ is the largest W so far.
struct Damage : SaintVenantKirchhoff {
  static constexpr auto name = "damage";

  std::vector<double> initial_values(int) const { return {0}; }
  /// Energy of a step from κ: e^{−κ} W; beyond κ it grows by ∫ e^{−s} ds.
  double energy(const Mat<3>& f, const Memory& memory) const {
    const double kappa = memory.committed[0], w = SaintVenantKirchhoff::energy(f), left = std::exp(-kappa);
    return w <= kappa ? left * w : left * kappa + left - std::exp(-w);
  }
  Mat<3> stress(const Mat<3>& f, const Memory& memory) const {
    memory.trial[0] = std::max(memory.committed[0], SaintVenantKirchhoff::energy(f));
    return std::exp(-memory.trial[0]) * SaintVenantKirchhoff::stress(f);
  }
  Moduli moduli(const Mat<3>& f, const Memory& memory) const {
    const double w = SaintVenantKirchhoff::energy(f);
    Moduli result = SaintVenantKirchhoff::moduli(f);
    if (w > memory.committed[0]) {
      const Mat<3> across = SaintVenantKirchhoff::stress(f).transpose();
      result -= across.reshaped() * across.reshaped().transpose();
    }
    return std::exp(-std::max(memory.committed[0], w)) * result;
  }
  Account account(const Mat<3>& f, std::span<const double> values) const {
    return {std::exp(-values[0]) * SaintVenantKirchhoff::energy(f), 0};
  }
};

/// A law of the program without kernels of its own.
template <Law T> struct Generic : ElasticConstants {
  static constexpr auto name = T::name;
  static constexpr bool linear = false;
  explicit Generic(const T& given) : ElasticConstants(given), law(given) {}
  double energy(const Mat<3>& f) const { return law.energy(f); }
  Mat<3> stress(const Mat<3>& f) const { return law.stress(f); }
  Moduli moduli(const Mat<3>& f) const { return law.moduli(f); }
  T law;
};

// A law with a missing function does not compile.
struct WithoutModuli : ElasticConstants {
  static constexpr auto name = "incomplete";
  static constexpr bool linear = false;
  double energy(const Mat<3>&) const { return 0; }
  Mat<3> stress(const Mat<3>&) const { return Mat<3>::Zero(); }
};
struct WithoutName : SaintVenantKirchhoff {
  static constexpr void* name = nullptr;
};
struct WithoutLinear : SaintVenantKirchhoff {
  int linear = 0;
};
struct WithoutConstants {
  static constexpr auto name = "incomplete";
  static constexpr bool linear = false;
  double energy(const Mat<3>&) const { return 0; }
  Mat<3> stress(const Mat<3>&) const { return Mat<3>::Zero(); }
  Moduli moduli(const Mat<3>&) const { return Moduli::Zero(); }
};
struct WithoutInitialValues : Damage {
  void initial_values(int) const {}
};
struct LinearDamage : Damage {
  static constexpr bool linear = true;
};
static_assert(Law<NeoHookean> && Law<LinearElastic> && Law<SaintVenantKirchhoff> && Law<Damage>);
static_assert(!Law<WithoutModuli> && !Law<WithoutName> && !Law<WithoutLinear> && !Law<WithoutConstants>);
static_assert(!Law<WithoutInitialValues> && !Law<LinearDamage> && !Law<Material>);
static_assert(!std::is_constructible_v<Material, WithoutModuli>);

const SaintVenantKirchhoff svk{elastic_constants(2, 0.3)};
const Damage brittle{{elastic_constants(2, 0.3)}};

template <int D> void kernels_agree(const std::vector<Body<D>>& bodies, const Material& generic) {
  Random random(21);
  for (const Body<D>& body : bodies)
    for (const double size : {0.0, 0.003, 0.015}) {
      const Body<D> twin(body.shared_space(), generic, body.kind());
      const VectorX u = random_displacement(random, body, size);
      const Assembled fast = assemble(body, u), slow = assemble(twin, u);
      ASSERT_FALSE(fast.inversion || slow.inversion);
      EXPECT_LT((fast.tangent - slow.tangent).norm(), 1e-13 * fast.tangent.norm());
      EXPECT_LT((fast.force - slow.force).norm(), 1e-12 * fast.force.norm() + 1e-15 * fast.tangent.norm());
      EXPECT_NEAR(stored_energy(body, u.data()), stored_energy(twin, u.data()), 1e-13 * fast.tangent.norm());
    }
}

TEST(Law, OwnKernelsAgreeWithThoseForAnyLaw) {
  const auto compare = [](const auto& law) {
    kernels_agree(plane_bodies(law), Generic(law));
    kernels_agree(bodies_of_revolution(law), Generic(law));
    kernels_agree(space_bodies(law), Generic(law));
  };
  compare(neo_hookean(2, 0.3));
  compare(neo_hookean(5, 0.45));
  compare(linear_elastic(2, 0.3));
}

TEST(Law, InversionIsReportedAsByOwnKernels) {
  const NeoHookean rubber = neo_hookean(2, 0.3);
  Random random(22);
  const auto compare = [&](const auto& bodies) {
    for (const auto& body : bodies) {
      const auto twin = std::decay_t<decltype(body)>(body.shared_space(), Generic(rubber), body.kind());
      for (const double size : {0.5, 2.0}) {
        const VectorX u = random_displacement(random, body, size);
        const Assembled fast = assemble(body, u), slow = assemble(twin, u);
        ASSERT_TRUE(fast.inversion && slow.inversion);
        EXPECT_EQ(fast.inversion->element, slow.inversion->element);
        EXPECT_EQ(fast.inversion->point, slow.inversion->point);
        EXPECT_NEAR(fast.inversion->jacobian, slow.inversion->jacobian, 1e-9 * std::abs(slow.inversion->jacobian));
      }
    }
  };
  compare(plane_bodies(rubber));
  compare(bodies_of_revolution(rubber));
  compare(space_bodies(rubber));
}

TEST(Law, ForceAndTangentOfANewLawAreDerivatives) {
  force_and_tangent_are_derivatives(plane_bodies(svk));
  force_and_tangent_are_derivatives(bodies_of_revolution(svk));
  force_and_tangent_are_derivatives(space_bodies(svk));
}

/// Σ_A f_A ⊗ X_A/V, which is P if P is uniform.
template <int D> Mat<D> mean_stress(const Body<D>& body, const VectorX& force) {
  const MatrixX points = body.space().points();
  Mat<D> sum = Mat<D>::Zero();
  for (int a = 0; a < body.functions(); ++a) sum += force.segment<D>(D * a) * points.col(a).transpose();
  double volume = 0;
  for (std::size_t q = 0; q < body.tables().points(); ++q) volume += body.tables().weights_of(0)[q];
  return sum / volume;
}

/// Simple shear F = I + γ e₁⊗e₂: E₁₂ = γ/2, E₂₂ = γ²/2, hence P₁₂ = μ γ + (λ/2 + μ) γ³, P₂₁ = μ γ and
/// P₂₂ = (λ/2 + μ) γ².
template <int D> void shear(const Body<D>& body) {
  Mat<D> f = Mat<D>::Identity();
  f(0, 1) = 0.4;
  const Mat<D> p = mean_stress<D>(body, assemble(body, affine<D>(body, f)).force);
  EXPECT_NEAR(p(0, 1), svk.mu * 0.4 + (svk.lambda / 2 + svk.mu) * 0.064, 1e-13);
  EXPECT_NEAR(p(1, 0), svk.mu * 0.4, 1e-13);
  EXPECT_NEAR(p(1, 1), (svk.lambda / 2 + svk.mu) * 0.16, 1e-13);
}

TEST(Law, SimpleShearOfANewLawHasItsClosedForm) {
  shear<2>(make_body<2>(nurbs::rectangle(2, 0.5, Eigen::Vector2d(0, 0)), {3, 2}, "N2-N2.1", "north", svk));
  shear<3>(make_body<3>(nurbs::block({2, 0.5, 0.4}, Eigen::Vector3d(0, 0, 0)), {2, 1, 1}, "N2", "back", svk));
}

/// Uniaxial tension at stretch a: S₁₁ = E E₁₁, E₂₂ = −ν E₁₁, hence P₁₁ = E a (a² − 1)/2 and b² = 1 − ν (a² − 1).
TEST(Law, UniaxialTensionOfANewLawHasItsClosedForm) {
  const Body<3> bar = make_body<3>(nurbs::block({2, 0.5, 0.4}, Eigen::Vector3d(0, 0, 0)), {2, 1, 1}, "N2", "back", svk);
  const auto zero = [](const Vec<3>&) { return 0.0; };
  for (const double a : {0.8, 1.4}) {
    std::map<int, double> prescribed;
    prescribe(bar, "west", 0, zero, prescribed);
    prescribe(bar, "south", 1, zero, prescribed);
    prescribe(bar, "front", 2, zero, prescribed);
    const auto pull = [&](const Vec<3>&) { return 2 * (a - 1); };
    prescribe(bar, "east", 0, pull, prescribed);
    VectorX u;
    const Assembled at = equilibrate(bar, prescribed, 12, u);
    ASSERT_FALSE(at.inversion);
    const double b = std::sqrt(1 - 0.3 * (a * a - 1));
    EXPECT_LT((u - affine<3>(bar, Vec<3>(a, b, b).asDiagonal())).norm(), 1e-12);
    EXPECT_NEAR(mean_stress(bar, at.force)(0, 0), a * (a * a - 1), 1e-12); // E = 2
  }
}

/// A tube with uniform radial stretch, F = diag(a, b, a).
TEST(Law, UniformStretchOfABodyOfRevolutionHasItsClosedForm) {
  const Body<2> disc =
      *revolved(make_body<2>(nurbs::rectangle(1.5, 0.5, Eigen::Vector2d(0, -1)), {3, 3}, "N2-N2.1", "south", svk, 2));
  const double a = 1.2, b = 0.9;
  const Mat<2> p = mean_stress(disc, assemble(disc, affine<2>(disc, Vec<2>(a, b).asDiagonal())).force);
  // S = λ tr E I + 2μ E; Σ_A f_rA R_A = (P_rr + P_θθ) V
  const double radial = (a * a - 1) / 2, axial = (b * b - 1) / 2, trace = 2 * radial + axial;
  EXPECT_NEAR(p(0, 0), 2 * a * (svk.lambda * trace + 2 * svk.mu * radial), 1e-13);
  EXPECT_NEAR(p(1, 1), b * (svk.lambda * trace + 2 * svk.mu * axial), 1e-13);
}

/// The force is the derivative of the step's energy, the tangent that of the force, for any committed values.
template <int D> void damage_is_consistent(const Body<D>& body) {
  Random random(23);
  std::vector<double> committed = initial_values(body), trial = committed;
  ASSERT_EQ(committed.size(), body.tables().points());
  const VectorX before = random_displacement(random, body, 0.01);
  assemble(body, before, {committed, trial});
  committed = trial;
  // Some points are unloaded, others loaded further.
  const VectorX u = 0.5 * before + random_displacement(random, body, 0.01);
  const Assembled at = assemble(body, u, {committed, trial});
  int loading = 0;
  for (std::size_t q = 0; q < trial.size(); ++q) loading += trial[q] > committed[q];
  EXPECT_GT(loading, 0);
  EXPECT_LT(loading, static_cast<int>(trial.size()));
  for (int i = 0; i < u.size(); ++i) {
    const auto moved = [&](double h) {
      VectorX v = u;
      v(i) += h;
      return v;
    };
    const auto energy = [&](double h) { return step_energy(body, moved(h).data(), {committed, {}, 0}); };
    const auto force = [&](double h) { return assemble(body, moved(h), {committed, trial}).force; };
    // The tangent is discontinuous where loading turns into unloading: small steps stay on one side.
    EXPECT_NEAR(signorini::test::derivative<double>(energy, 1e-6), at.force(i), 1e-7 * at.force.norm());
    EXPECT_LT((signorini::test::derivative<VectorX>(force, 1e-6) - at.tangent.col(i)).norm(), 1e-7 * at.tangent.norm());
  }
}

TEST(Law, DamageIsConsistentInAllKinds) {
  damage_is_consistent(plane_bodies(brittle).front());
  damage_is_consistent(bodies_of_revolution(brittle).front());
  damage_is_consistent(space_bodies(brittle).front());
}

/// An accepted step commits its damage, a rolled-back step leaves none.
TEST(Law, InternalVariablesCommitAndRollBack) {
  const Body<2> body =
      make_body<2>(nurbs::rectangle(2, 0.5, Eigen::Vector2d(0, 0)), {3, 2}, "N2-N2.1", "north", brittle);
  const auto stretched = [&](double a) { return affine<2>(body, Vec<2>(a, 1).asDiagonal()); };
  // W = (λ/2 + μ) e² and P₁₁ = a (λ + 2μ) e with e = (a² − 1)/2
  const double modulus = brittle.lambda + 2 * brittle.mu;
  const auto energy = [&](double a) { return modulus * (a * a - 1) * (a * a - 1) / 8; };
  const auto elastic = [&](double a) { return modulus * a * (a * a - 1) / 2; };
  std::vector<double> committed = initial_values(body), trial = committed;
  const auto pull = [&](double a) {
    return mean_stress(body, assemble(body, stretched(a), {committed, trial}).force)(0, 0);
  };

  EXPECT_NEAR(pull(1.3), std::exp(-energy(1.3)) * elastic(1.3), 1e-13);
  for (const double kappa : trial) EXPECT_NEAR(kappa, energy(1.3), 1e-13);
  // Rolled back: the trial values are discarded.
  const double virgin = pull(1.1);
  EXPECT_NEAR(virgin, std::exp(-energy(1.1)) * elastic(1.1), 1e-13);

  EXPECT_NEAR(pull(1.3), std::exp(-energy(1.3)) * elastic(1.3), 1e-13);
  committed = trial; // accepted
  EXPECT_NEAR(pull(1.1), std::exp(-energy(1.3)) * elastic(1.1), 1e-13);
  EXPECT_EQ(trial, committed);
  const double damaged = pull(1.1);
  pull(1.6);
  EXPECT_NE(trial, committed);
  EXPECT_EQ(pull(1.1), damaged); // rolled back to the damage of 1.3
  EXPECT_LT(damaged, 0.95 * virgin);
}

TEST(Law, InternalVariablesOfWrongSizeAreAnError) {
  const Body<2> body = plane_bodies(brittle).front();
  const VectorX u = VectorX::Zero(2 * body.functions());
  EXPECT_ERROR(assemble(body, u),
               "solid.body.internal_variables: material = damage, expected = 48, committed = 0, trial = 0");
  std::vector<double> committed = initial_values(body), trial = committed;
  trial.pop_back();
  EXPECT_ERROR(assemble(body, u, {committed, trial}),
               "solid.body.internal_variables: material = damage, expected = 48, committed = 48, trial = 47");
  EXPECT_TRUE(initial_values(plane_bodies(svk).front()).empty());
}

TEST(Law, FilesStoreTheLawsOfTheProgram) {
  for (const Material& material : {Material(neo_hookean(3, 0.35)), Material(linear_elastic(3, 0.35))}) {
    ArchiveWriter to;
    write(to, material);
    EXPECT_EQ(to.bytes().size(), sizeof(int) + 4 * sizeof(double));
    ArchiveReader from(to.bytes());
    const Material back = from.get<Material>();
    EXPECT_STREQ(back.name(), material.name());
    EXPECT_EQ(back.linear(), material.linear());
    EXPECT_EQ(back.constants().lambda, material.constants().lambda);
  }
  ArchiveWriter to;
  EXPECT_ERROR(write(to, svk), "solid.archive.unknown_law");
  to.put(7);
  ArchiveReader from(to.bytes());
  EXPECT_ERROR(from.get<Material>(), "solid.archive.law: number = 7");
}

} // namespace law_test
} // namespace signorini::solid
