#include "base/dense.hpp"
#include "solid/archive.hpp"
#include "solid/energy.hpp"
#include "solid/hyperelastic.hpp"
#include "solid/kernel_wide.hpp"
#include "solid/stability.hpp"

#include "solid/many_bodies.hpp"

#include <cmath>

namespace signorini::solid {
namespace hyperelastic_test {

using namespace test;
using symbolic::Graph;
using symbolic::Operation;

/// A law from a function (Graph&) → node.
template <class Write> Hyperelastic law_of(const Write& write, std::vector<Vec<3>> fibers = {}) {
  Graph graph(variable_names(Measure::invariants, fibers.size()));
  const int energy = write(graph);
  return hyperelastic({"test", Measure::invariants, std::move(fibers), std::move(graph), energy});
}

template <class Write> Hyperelastic law_of_stretches(const Write& write) {
  Graph graph(variable_names(Measure::stretches, 0));
  const int energy = write(graph);
  return hyperelastic({"test", Measure::stretches, {}, std::move(graph), energy});
}

/// c x
int times(Graph& g, double c, int x) {
  return g.multiply(g.constant(c), x);
}
/// x + c
int plus(Graph& g, int x, double c) {
  return g.add(g.constant(c), x);
}
/// k/4 (J² − 1 − 2 ln J)
int volumetric(Graph& g, double k, int j) {
  return times(g, k / 4, g.subtract(plus(g, g.power(j, 2.0), -1), times(g, 2, g.apply(Operation::log, j))));
}

/// The program's neo-Hooke.
Hyperelastic rubber(const ElasticConstants& c) {
  return law_of([&](Graph& g) {
    const int log = g.apply(Operation::log, 2);
    return g.add(g.subtract(times(g, c.mu / 2, plus(g, 0, -3)), times(g, c.mu, log)),
                 times(g, c.lambda / 2, g.power(log, 2.0)));
  });
}

Hyperelastic rubber_by_stretches(const ElasticConstants& c) {
  return law_of_stretches([&](Graph& g) {
    const int log = g.apply(Operation::log, g.multiply(0, g.multiply(1, 2)));
    const int trace = g.add(g.power(0, 2.0), g.add(g.power(1, 2.0), g.power(2, 2.0)));
    return g.add(g.subtract(times(g, c.mu / 2, plus(g, trace, -3)), times(g, c.mu, log)),
                 times(g, c.lambda / 2, g.power(log, 2.0)));
  });
}

int isochoric_mooney_rivlin(Graph& g, double c10, double c01) {
  return g.add(times(g, c10, plus(g, g.multiply(g.power(2, -2.0 / 3), 0), -3)),
               times(g, c01, plus(g, g.multiply(g.power(2, -4.0 / 3), 1), -3)));
}

Hyperelastic mooney_rivlin() {
  return law_of([](Graph& g) { return g.add(isochoric_mooney_rivlin(g, 0.4, 0.2), volumetric(g, 3, 2)); });
}

/// Mooney–Rivlin with two families of fibers, coupled to the volume.
Hyperelastic fibers() {
  return law_of(
      [](Graph& g) {
        int energy = g.add(isochoric_mooney_rivlin(g, 0.4, 0.2), volumetric(g, 3, 2));
        for (int i4 : {3, 4})
          energy = g.add(energy, times(g, 0.7, g.power(plus(g, g.multiply(g.power(2, -2.0 / 3), i4), -1), 2.0)));
        return energy;
      },
      {Vec<3>(1, 2, 0), Vec<3>(0.5, -1, 0.7)});
}

Hyperelastic ogden() {
  return law_of_stretches([](Graph& g) {
    const int j = g.multiply(0, g.multiply(1, 2));
    int energy = volumetric(g, 3, j);
    for (const auto& [mu, alpha] : {std::pair(0.6, 1.3), std::pair(0.1, 5.0), std::pair(-0.05, -2.0)}) {
      int sum = g.constant(-3);
      for (int l : {0, 1, 2}) sum = g.add(sum, g.multiply(g.power(j, -alpha / 3), g.power(l, alpha)));
      energy = g.add(energy, times(g, mu / alpha, sum));
    }
    return energy;
  });
}

Mat<3> random_deformation(Random& random, double size = 0.6) {
  for (;;) {
    Mat<3> f = Mat<3>::Identity();
    for (double& entry : f.reshaped()) entry += uniform(random, -size, size);
    if (f.determinant() > 0.3 && f.determinant() < 3) return f;
  }
}

TEST(Hyperelastic, StressAndModuliAreDerivatives) {
  Random random(31);
  for (const Hyperelastic& law : {rubber(elastic_constants(2, 0.3)), mooney_rivlin(), fibers(), ogden(),
                                  rubber_by_stretches(neo_hookean(2, 0.3))})
    for (int trial = 0; trial < 20; ++trial) {
      const Mat<3> f = random_deformation(random), p = law.stress(f);
      const Moduli moduli = law.moduli(f);
      for (int entry = 0; entry < 9; ++entry) {
        const auto moved = [&](double h) {
          Mat<3> result = f;
          result(entry / 3, entry % 3) += h;
          return result;
        };
        const auto energy = [&](double h) { return law.energy(moved(h)); };
        const auto stress = [&](double h) { return law.stress(moved(h)); };
        EXPECT_NEAR(signorini::test::derivative<double>(energy, 1e-3), p(entry / 3, entry % 3), 1e-7 * (1 + p.norm()));
        const Mat<3> slope = signorini::test::derivative<Mat<3>>(stress, 1e-3).transpose();
        EXPECT_LT((slope.reshaped() - moduli.col(entry)).norm(), 1e-6 * moduli.norm());
      }
    }
}

TEST(Hyperelastic, ConstantsAreThoseOfSmallStrains) {
  const ElasticConstants given = elastic_constants(5, 0.45);
  for (const Hyperelastic& law : {rubber(given), rubber_by_stretches(given)}) {
    EXPECT_NEAR(law.youngs_modulus, 5, 1e-12);
    EXPECT_NEAR(law.poissons_ratio, 0.45, 1e-13);
    EXPECT_NEAR(law.lambda, given.lambda, 1e-12);
  }
  EXPECT_NEAR(mooney_rivlin().mu, 2 * (0.4 + 0.2), 1e-13);
  EXPECT_NEAR(mooney_rivlin().lambda + 2 * mooney_rivlin().mu / 3, 3, 1e-12);
  EXPECT_NEAR(ogden().mu, 0.5 * (0.6 * 1.3 + 0.1 * 5 + 0.05 * 2), 1e-13);
}

/// Almost equal stretches, at which moduli are a quotient of small differences, and equal ones.
TEST(Hyperelastic, StretchesAgreeWithInvariants) {
  const NeoHookean given = neo_hookean(2, 0.4);
  const Hyperelastic law = rubber_by_stretches(given);
  Random random(32);
  for (const double difference : {0.3, 1e-3, 1.01e-5, 0.99e-5, 1e-7, 1e-12, 0.0}) {
    const Mat<3> q = dense::orthogonal(random_deformation(random));
    const Vec<3> stretches(1.2, 1.2 + difference, 0.8 - difference);
    const Mat<3> f = q * stretches.asDiagonal() * q.transpose() * Mat<3>{{0.8, -0.6, 0}, {0.6, 0.8, 0}, {0, 0, 1}};
    EXPECT_NEAR(law.energy(f), given.energy(f), 1e-14);
    EXPECT_LT((law.stress(f) - given.stress(f)).norm(), 1e-14);
    EXPECT_LT((law.moduli(f) - given.moduli(f)).norm(), 1e-9);
  }
  EXPECT_LT((law.moduli(Mat<3>::Identity()) - given.moduli(Mat<3>::Identity())).norm(), 1e-13);
}

template <int D> void bodies_agree(const std::vector<Body<D>>& bodies, const Material& formula) {
  Random random(33);
  for (const Body<D>& body : bodies)
    for (const double size : {0.0, 0.003, 0.015}) {
      const Body<D> twin(body.shared_space(), formula, body.kind());
      const VectorX u = random_displacement(random, body, size);
      const Assembled by_hand = assemble(body, u), compiled = assemble(twin, u);
      ASSERT_FALSE(by_hand.inversion || compiled.inversion);
      EXPECT_LT((by_hand.tangent - compiled.tangent).norm(), 1e-12 * by_hand.tangent.norm());
      EXPECT_LT((by_hand.force - compiled.force).norm(), 1e-12 * by_hand.force.norm() + 1e-15 * by_hand.tangent.norm());
      EXPECT_NEAR(stored_energy(body, u.data()), stored_energy(twin, u.data()), 1e-13 * by_hand.tangent.norm());
    }
}

/// The bodies under plane stress.
std::vector<Body<2>> plates(const Material& material) {
  std::vector<Body<2>> bodies;
  for (const Body<2>& body : plane_bodies(material)) bodies.push_back(*in_plane_stress(body));
  return bodies;
}

TEST(Hyperelastic, FormulaOfNeoHookeAgreesWithItsKernels) {
  const NeoHookean by_hand = neo_hookean(2, 0.3);
  for (const Hyperelastic& law : {rubber(by_hand), rubber_by_stretches(by_hand)}) {
    bodies_agree(plane_bodies(by_hand), law);
    bodies_agree(bodies_of_revolution(by_hand), law);
    bodies_agree(plates(by_hand), law);
    bodies_agree(space_bodies(by_hand), law);
  }
}

/// The last of some bodies, for laws that take long to compute.
template <int D> std::vector<Body<D>> last_of(const std::vector<Body<D>>& bodies) {
  return {bodies.back()};
}

TEST(Hyperelastic, ForceAndTangentAreDerivatives) {
  force_and_tangent_are_derivatives(plane_bodies(fibers()));
  force_and_tangent_are_derivatives(last_of(bodies_of_revolution(fibers())));
  force_and_tangent_are_derivatives(last_of(space_bodies(fibers())));
  force_and_tangent_are_derivatives(last_of(plane_bodies(ogden())));
}

TEST(Hyperelastic, ForceAndTangentUnderPlaneStressAreDerivatives) {
  for (const Material& law :
       {Material(neo_hookean(2, 0.3)), Material(linear_elastic(2, 0.3)), Material(fibers()), Material(ogden())})
    force_and_tangent_are_derivatives(last_of(plates(law)));
}

TEST(Hyperelastic, ThicknessStretchHasNoStressAcross) {
  Random random(34);
  for (const Material& material :
       {Material(neo_hookean(2, 0.3)), Material(linear_elastic(2, 0.3)), Material(neo_hookean(2, 0.4999)),
        Material(neo_hookean(2, -0.3)), Material(mooney_rivlin()), Material(fibers()), Material(ogden())})
    for (int trial = 0; trial < 20; ++trial) {
      const double size = material.linear() ? 0.1 : 0.5;
      const Mat<2> f = random_deformation(random, size).topLeftCorner<2, 2>();
      if (!(f.determinant() > 0.2)) continue;
      const Mat<3> p = material.stress(in_space<2>(f, material.thickness_stretch(f)));
      EXPECT_NEAR(p(2, 2), 0, 1e-12 * (1 + material.constants().lambda)) << material.name() << f;
    }
}

/// Uniaxial tension of a strip under plane stress is that of a bar: P₁₁ = μ (a − b²/a) with b from λ ln J = μ (1 − b²).
TEST(Hyperelastic, PlateOfNeoHookeIsABarInTension) {
  const NeoHookean law = neo_hookean(2, 0.3);
  const auto plate = plates(law).back();
  const double a = 1.5;
  double b = 0.8;
  for (int i = 0; i < 50; ++i) {
    const double value = law.lambda * std::log(a * b * b) + law.mu * (b * b - 1);
    b -= value / (2 * law.lambda / b + 2 * law.mu * b);
  }
  EXPECT_NEAR(Material(law).thickness_stretch(Vec<2>(a, b).asDiagonal()), b, 1e-14);
  const VectorX u = affine<2>(plate, Vec<2>(a, b).asDiagonal());
  const Assembled at = assemble(plate, u);
  double pull = 0;
  for (int function : plate.space().face_functions(nurbs::side_of("east", 2))) pull += at.force(2 * function);
  EXPECT_NEAR(pull, 2 * law.mu * (a - b * b / a), 1e-13); // the edge has length 2
}

/// An energy without a stable thickness, W = (I₁ − 3)/2 − x + x²/2 − 250 x⁴ with x = J − 1: the element counts as
/// inverted, with F₃₃ = 0.
TEST(Hyperelastic, PlatesWithoutThicknessAreReported) {
  const Hyperelastic law = law_of([](Graph& g) {
    const int x = plus(g, 2, -1), parts = g.subtract(times(g, 0.5, g.power(x, 2.0)), times(g, 250, g.power(x, 4.0)));
    return g.add(times(g, 0.5, plus(g, 0, -3)), g.subtract(parts, x));
  });
  const auto plate = plates(law).back();
  const Assembled at = assemble(plate, affine<2>(plate, Vec<2>(3, 3).asDiagonal()));
  ASSERT_TRUE(at.inversion);
  EXPECT_EQ(at.inversion->jacobian, 0);
}

TEST(Hyperelastic, InversionIsReportedAsByTheKernelsOfNeoHooke) {
  const NeoHookean by_hand = neo_hookean(2, 0.3);
  Random random(35);
  const auto compare = [&](const auto& bodies) {
    for (const auto& body : bodies) {
      const auto twin = std::decay_t<decltype(body)>(body.shared_space(), rubber(by_hand), body.kind());
      for (const double size : {0.5, 2.0}) {
        const VectorX u = random_displacement(random, body, size);
        const Assembled expected = assemble(body, u), found = assemble(twin, u);
        ASSERT_TRUE(expected.inversion && found.inversion);
        EXPECT_EQ(expected.inversion->element, found.inversion->element);
        EXPECT_NEAR(expected.inversion->jacobian, found.inversion->jacobian,
                    1e-9 * std::abs(expected.inversion->jacobian));
      }
    }
  };
  compare(plane_bodies(by_hand));
  compare(bodies_of_revolution(by_hand));
  compare(space_bodies(by_hand));
}

/// Neo-Hooke at unit stiffness on one element, by one kernel.
template <int D> std::vector<double> run(const Body<D>& body, Kernel kernel, const VectorX& u) {
  ElementArrays<D> arrays(body);
  KernelArguments arguments = body.tables().arguments(0, body.material());
  const auto functions = body.tables().functions_of(0);
  const std::size_t n = functions.size();
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t i = 0; i < D; ++i) arrays.local[i * n + a] = u(D * functions[a] + static_cast<int>(i));
  arguments.local = arrays.local.data();
  arguments.force = arrays.force.data();
  arguments.work = arrays.work.data();
  arguments.factors = arrays.factors.data();
  arguments.blocks = arrays.blocks.data();
  EXPECT_LT(kernel(arguments).point, 0);
  std::vector<double> result(arrays.force.begin(), arrays.force.begin() + static_cast<long>(D * n));
  result.insert(result.end(), arrays.blocks.begin(),
                arrays.blocks.begin() + static_cast<long>(D * (D + 1) / 2 * n * n));
  return result;
}

template <int D> void all_widths_agree(const std::vector<Body<D>>& bodies) {
  Random random(36);
  for (const Body<D>& body : bodies) {
    const VectorX u = random_displacement(random, body, 0.015);
    const std::vector<Kernel> kernels = moduli_kernels<D>();
    const std::vector<double> first = run(body, kernels.front(), u);
    for (const Kernel& kernel : kernels) {
      const std::vector<double> other = run(body, kernel, u);
      for (std::size_t i = 0; i < first.size(); ++i) EXPECT_NEAR(other[i], first[i], 1e-12);
    }
  }
}

/// Also the responses, of which the kernels above all call the widest.
template <int D> void all_responses_agree(const Hyperelastic& law) {
  constexpr int entries = entries_in(D), rows = entries + packed_size(entries);
  constexpr int points = 37, stride = 40; // more than one chunk, not whole vectors
  Random random(38);
  std::vector<double> f(entries * stride), first;
  for (int q = 0; q < stride; ++q) {
    const Mat<3> one = random_deformation(random, 0.2);
    for (int e = 0; e < entries; ++e) {
      const int entry = D == 3 ? e : plane_entries[e];
      f[e * stride + q] = one(entry / 3, entry % 3);
    }
  }
  for (const EnergyResponse respond : energy_responses<D>()) {
    std::vector<double> values(rows * stride);
    respond(law.compiled->program, {points, stride, f.data(), values.data(), values.data() + entries * stride});
    if (first.empty()) first = values;
    for (int row = 0; row < rows; ++row)
      for (int q = 0; q < points; ++q) EXPECT_NEAR(values[row * stride + q], first[row * stride + q], 1e-12);
  }
}

TEST(Hyperelastic, AllVectorWidthsAgree) {
  all_widths_agree(plane_bodies(fibers()));
  all_widths_agree(bodies_of_revolution(fibers()));
  all_widths_agree(space_bodies(fibers()));
  EXPECT_EQ(energy_responses<3>().size(), moduli_kernels<3>().size());
  all_responses_agree<2>(fibers());
  all_responses_agree<3>(fibers());
}

/// Saint Venant–Kirchhoff with ν = 0: τ = E (a⁴ − a²)/2 has the slope E (2a⁴ − a²) by ln a; for neo-Hooke at F = 1.2 I
/// the least modulus is 2μ a².
TEST(Hyperelastic, LeastModulusIsThatOfLogarithmicStrain) {
  const Hyperelastic softening = law_of([](Graph& g) { // E = 1: tr E² / 2
    const int sum = g.subtract(g.power(0, 2.0), g.add(times(g, 2, 1), times(g, 2, 0)));
    return times(g, 1.0 / 8, plus(g, sum, 3));
  });
  for (const double a : {0.6, 0.7, 0.72}) {
    const Mat<3> f = Vec<3>(a, 1, 1).asDiagonal();
    EXPECT_NEAR(least_modulus(softening, f), 2 * std::pow(a, 4) - a * a, 1e-14);
  }
  const NeoHookean by_hand = neo_hookean(2, 0.3);
  EXPECT_NEAR(least_modulus(rubber(by_hand), 1.2 * Mat<3>::Identity()), 2 * by_hand.mu * 1.44, 1e-13);
}

TEST(Hyperelastic, FilesStoreTheFormula) {
  Random random(37);
  for (const Hyperelastic& law : {mooney_rivlin(), fibers(), ogden()}) {
    ArchiveWriter to;
    write(to, Material(law));
    ArchiveReader from(to.bytes());
    const Material back = from.get<Material>();
    EXPECT_EQ(from.remaining(), 0U);
    const Mat<3> f = random_deformation(random);
    EXPECT_EQ(back.stress(f), law.stress(f));
    ArchiveWriter again;
    write(again, back);
    EXPECT_EQ(again.bytes(), to.bytes());
    EXPECT_EQ(hyperelastic_law(back)->formula().label, "test");
  }
  EXPECT_EQ(hyperelastic_law(neo_hookean(1, 0.3)), nullptr);
}

TEST(Hyperelastic, EnergiesThatAreNoElasticLawAreErrors) {
  EXPECT_ERROR(law_of([](Graph& g) { return plus(g, 0, -3); }), "solid.energy.stress: stress = (2, 2, 2)");
  EXPECT_ERROR(law_of([](Graph& g) { return g.power(plus(g, 0, -3), 2.0); }), "solid.energy.moduli: bulk = ");
  EXPECT_ERROR(law_of([](Graph& g) { return g.apply(Operation::log, plus(g, 2, -1)); }), "solid.energy.not_finite");
  EXPECT_ERROR(law_of([](Graph& g) { return times(g, -1, isochoric_mooney_rivlin(g, 1, 1)); }), "solid.energy.moduli");
  EXPECT_ERROR(law_of_stretches([](Graph& g) { return g.power(plus(g, 0, -1), 2.0); }), "solid.energy.asymmetric");
  EXPECT_ERROR(law_of([](Graph& g) { return g.power(plus(g, 2, -1), 2.0); }, {Vec<3>::Zero()}),
               "solid.energy.direction: number = 1");
}

} // namespace hyperelastic_test
} // namespace signorini::solid
