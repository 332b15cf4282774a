// Viscoelastic laws: derivatives, closed forms of a material point, limits, and viscous work.
#include "solid/archive.hpp"
#include "solid/hyperelastic.hpp"
#include "solid/many_bodies.hpp"
#include "solid/viscoelastic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace signorini::solid {
namespace viscoelastic_test {

using namespace test;

const std::vector<Relaxation> series{{0.3, 0.1}, {0.2, 10}};
constexpr double infinite = std::numeric_limits<double>::infinity();

/// W = μ/2 (J^(−2/3) I₁ − 3) + K/4 (J² − 1 − 2 ln J), or Saint Venant–Kirchhoff.
Material formula(bool saint_venant) {
  symbolic::Graph graph(variable_names(Measure::invariants, 0));
  const auto number = [&](double value) { return graph.constant(value); };
  const int i1 = graph.variable(0), i2 = graph.variable(1), j = graph.variable(2);
  const auto sum = [&](int a, int b) { return graph.add(a, b); };
  const auto times = [&](double a, int b) { return graph.multiply(number(a), b); };
  int energy = 0;
  if (saint_venant) {
    // λ/8 (I₁ − 3)² + μ/4 (I₁² − 2 I₂ − 2 I₁ + 3)
    const int strain = sum(i1, number(-3));
    energy = sum(times(0.5, graph.multiply(strain, strain)),
                 times(0.25, sum(graph.multiply(i1, i1), sum(times(-2, i2), sum(times(-2, i1), number(3))))));
  } else {
    const int shape = graph.multiply(graph.power(j, -2.0 / 3), i1);
    energy =
        sum(times(0.5, sum(shape, number(-3))),
            times(2, sum(graph.multiply(j, j), sum(number(-1), times(-2, graph.apply(symbolic::Operation::log, j))))));
  }
  return hyperelastic({"formula", Measure::invariants, {}, graph, energy});
}

std::vector<Material> laws() {
  std::vector<Material> all;
  for (const Relaxes relaxes : {Relaxes::shape, Relaxes::all})
    for (const Material& elastic : {Material(neo_hookean(2, 0.3)), Material(linear_elastic(2, 0.3)), formula(false)})
      all.push_back(viscoelastic(elastic, series, relaxes));
  return all;
}

/// Force and tangent against differences, after a step that leaves overstresses.
template <int D> void is_consistent(const Body<D>& body, double duration) {
  Random random(31);
  std::vector<double> committed = initial_values(body), trial = committed;
  const VectorX before = random_displacement(random, body, 0.01);
  assemble(body, before, {committed, trial, 0.05});
  committed = trial;
  const VectorX u = before + random_displacement(random, body, 0.01);
  const Memory memory{committed, trial, duration};
  const Assembled at = assemble(body, u, memory);
  ASSERT_FALSE(at.inversion);
  for (int i = 0; i < u.size(); i += 3) {
    const auto moved = [&](double h) {
      VectorX v = u;
      v(i) += h;
      return v;
    };
    const auto energy = [&](double h) { return step_energy(body, moved(h).data(), memory); };
    const auto force = [&](double h) { return assemble(body, moved(h), memory).force; };
    EXPECT_NEAR(signorini::test::derivative<double>(energy, 2e-4), at.force(i), 1e-7 * at.force.norm());
    EXPECT_LT((signorini::test::derivative<VectorX>(force, 2e-4) - at.tangent.col(i)).norm(), 1e-7 * at.tangent.norm());
  }
}

TEST(Viscoelastic, ForceAndTangentAreDerivatives) {
  for (const Material& law : laws())
    for (const double duration : {0.0, 0.2, infinite}) {
      is_consistent(plane_bodies(law).back(), duration);
      is_consistent(*in_plane_stress(plane_bodies(law).back()), duration);
      is_consistent(bodies_of_revolution(law).front(), duration);
      is_consistent(space_bodies(law).front(), duration);
      const Body<2> plane = plane_bodies(law).back();
      is_consistent(Body<2>(plane.shared_space(), law, plane.kind(), Volumetric::projected), duration);
    }
}

/// F of a strain path, in large steps: a shear and a stretch that grow with the path.
Mat<3> deformation(double s) {
  Mat<3> f = Mat<3>::Identity();
  f(0, 1) = 0.5 * s;
  f(0, 0) = 1 + 0.3 * s;
  f(2, 2) = 1 - 0.1 * s;
  return f;
}

/// A point that remembers.
struct Point {
  Point(const Material& law, int dimensions) : material(law), committed(law.initial_values(dimensions)) {}
  Mat<3> step(const Mat<3>& f, double duration) {
    std::vector<double> trial = committed;
    const Mat<3> p = material.stress(f, {committed, trial, duration});
    error = step_error(*viscoelastic_law(material), {committed, trial, duration});
    committed = trial;
    return p;
  }
  const Material& material;
  std::vector<double> committed;
  double error = 0;
};

/// Where Z grows in proportion to time, steps of any length are exact: of Saint Venant–Kirchhoff with C = I + t Ċ,
/// S = ℂ:Ė [g_∞ t + Σ g_i τ_i (1 − e^(−t/τ_i))], then the decay of each term.
TEST(Viscoelastic, StrainThatGrowsWithTimeHasItsClosedForm) {
  const Material elastic = formula(true), law = viscoelastic(elastic, series, Relaxes::all);
  const Mat<3> rate{{0.2, 0.1, 0}, {0.1, -0.1, 0}, {0, 0, 0.05}}; // of C
  const auto stretch = [&](double t) {                            // U with U² = I + t Ċ
    const Eigen::SelfAdjointEigenSolver<Mat<3>> solver(Mat<3>::Identity() + t * rate);
    return solver.operatorSqrt();
  };
  const auto second = [&](const Mat<3>& f, const Mat<3>& p) { return Mat<3>(f.inverse() * p); };
  for (const int dimensions : {2, 3}) {
    Point point(law, dimensions);
    double time = 0;
    for (const double duration : {0.02, 0.7, 1.1}) {
      time += duration;
      const Mat<3> f = stretch(time), unit = second(f, elastic.stress(f)) / time; // ℂ:Ė
      double expected = 0.5 * time;
      for (const auto& [fraction, tau] : series) expected += fraction * tau * (1 - std::exp(-time / tau));
      EXPECT_LT((second(f, point.step(f, duration)) - expected * unit).norm(), 1e-12 * unit.norm());
    }
    const double top = time;
    const Mat<3> f = stretch(top), unit = second(f, elastic.stress(f)) / top;
    for (const double duration : {0.05, 3.0, infinite}) {
      time += duration;
      double expected = 0.5 * top;
      for (const auto& [fraction, tau] : series)
        expected += fraction * tau * (1 - std::exp(-top / tau)) * std::exp(-(time - top) / tau);
      EXPECT_LT((second(f, point.step(f, duration)) - expected * unit).norm(), 1e-12 * unit.norm());
    }
  }
}

TEST(Viscoelastic, StepsWithoutDurationAreElasticAndEndlessOnesRelaxed) {
  for (const Material& law : laws()) {
    const Viscoelastic& own = *viscoelastic_law(law);
    Point fast(law, 3), slow(law, 3);
    for (const double s : {0.4, 1.0, 0.7}) {
      const Mat<3> f = deformation(s), p = own.elastic.stress(f);
      EXPECT_LT((fast.step(f, 0) - p).norm(), 1e-12 * p.norm());
      const Mat<3> rest = slow.step(f, infinite);
      if (own.relaxes == Relaxes::all) {
        EXPECT_LT((rest - 0.5 * p).norm(), 1e-12 * p.norm());
      }
      // The mean stress of "shape" does not relax, the rest does.
      const auto mean = [&](const Mat<3>& stress) {
        return law.small_strains() ? stress.trace() : Mat<3>(stress * f.transpose()).trace();
      };
      if (own.relaxes == Relaxes::shape) {
        EXPECT_NEAR(mean(rest), mean(p), 1e-12 * p.norm());
      }
    }
  }
}

/// A shear of small amplitude: work per cycle π G″ γ₀² with G″ = G Σ g ωτ/(1 + ω²τ²), second order in the step.
TEST(Viscoelastic, CyclesDissipateByTheLossModulus) {
  constexpr double pi = 3.14159265358979323846, amplitude = 1e-3, frequency = 2 * pi;
  for (const Relaxes relaxes : {Relaxes::shape, Relaxes::all}) {
    const Material law = viscoelastic(linear_elastic(2.6, 0.3), {{0.4, 0.2}}, relaxes); // G = 1
    const double x = frequency * 0.2, loss = pi * 0.4 * x / (1 + x * x) * amplitude * amplitude;
    std::vector<double> errors;
    for (const int steps : {50, 100}) {
      Point point(law, 2);
      double before = 0;
      for (int i = 1; i <= 12 * steps; ++i) {
        Mat<3> f = Mat<3>::Identity();
        f(0, 1) = amplitude * std::sin(frequency * i / steps);
        point.step(f, 1.0 / steps);
        if (i == 11 * steps) before = law.account(f, point.committed).viscous;
        if (i == 12 * steps) errors.push_back((law.account(f, point.committed).viscous - before) / loss - 1);
      }
    }
    EXPECT_LT(std::abs(errors[1]), 1e-3);
    EXPECT_NEAR(errors[0] / errors[1], 4, 0.1);
  }
}

/// The viscous work of random paths up to stretches of 2.5 is never negative; where all stress relaxes, of those that
/// keep the volume: for large changes of volume convolution does not guarantee it.
TEST(Viscoelastic, ViscousWorkIsNeverNegative) {
  Random random(5);
  for (const Material& law : laws()) {
    if (law.small_strains()) continue;
    for (int path = 0; path < 250; ++path) {
      Point point(law, 3);
      Mat<3> f = Mat<3>::Identity();
      for (int i = 0; i < 20; ++i) {
        Mat<3> rate;
        for (double& value : rate.reshaped()) value = uniform(random, -0.3, 0.3);
        Mat<3> next = (Mat<3>::Identity() + rate) * f;
        const double duration = std::exp(uniform(random, -4, 3));
        const Vec<3> stretches = next.jacobiSvd().singularValues();
        if (next.determinant() < 0.5 || stretches(0) > 2.5 || stretches(2) < 0.4) continue;
        if (viscoelastic_law(law)->relaxes == Relaxes::all) next /= std::cbrt(next.determinant());
        f = next;
        point.step(f, duration);
        EXPECT_GE(law.account(f, point.committed).viscous, -1e-12);
      }
    }
  }
}

/// The estimate follows the error of backward Euler: first order in the step, none without duration.
TEST(Viscoelastic, ErrorOfAStepGrowsWithItsDuration) {
  const Material law = viscoelastic(neo_hookean(2, 0.3), series, Relaxes::shape);
  std::vector<double> errors;
  for (const double duration : {0.0, 1e-4, 2e-4, infinite}) {
    Point point(law, 3);
    point.step(deformation(0.5), 0);
    point.step(deformation(0.6), duration);
    errors.push_back(point.error);
  }
  EXPECT_EQ(errors[0], 0);
  EXPECT_NEAR(errors[2] / errors[1], 2, 0.01);
  EXPECT_EQ(errors[3], 0);
}

TEST(Viscoelastic, WrongSeriesAreErrors) {
  const Material law = neo_hookean(2, 0.3);
  EXPECT_ERROR(viscoelastic(law, {}, Relaxes::all), "solid.viscoelastic.empty");
  EXPECT_ERROR(viscoelastic(law, {{0.5, 1}, {0.5, 2}}, Relaxes::all), "solid.viscoelastic.sum: sum = 1");
  EXPECT_ERROR(viscoelastic(law, {{-0.5, 1}}, Relaxes::all), "solid.viscoelastic.fraction: value = -0.5");
  EXPECT_ERROR(viscoelastic(law, {{0.5, 0}}, Relaxes::all), "solid.viscoelastic.time: value = 0");
  EXPECT_ERROR(viscoelastic(viscoelastic(law, series, Relaxes::all), series, Relaxes::all),
               "solid.viscoelastic.law: material = viscoelastic");
}

TEST(Viscoelastic, FilesStoreTheSeries) {
  for (const Material& law : laws()) {
    ArchiveWriter to;
    write(to, law);
    ArchiveReader from(to.bytes());
    const Material back = from.get<Material>();
    const Viscoelastic &own = *viscoelastic_law(law), &other = *viscoelastic_law(back);
    EXPECT_STREQ(other.elastic.name(), own.elastic.name());
    EXPECT_EQ(other.relaxes, own.relaxes);
    ASSERT_EQ(other.series.size(), 2u);
    EXPECT_EQ(other.series[1].time, 10);
    EXPECT_EQ(back.stress(deformation(1)), law.stress(deformation(1)));
  }
}

} // namespace viscoelastic_test
} // namespace signorini::solid
