// Bodies compared with closed forms: uniaxial tension and confined compression at finite strain, a thick ring at small
// strain.
#include "solid/bodies.hpp"
#include "solid/internal.hpp"
#include "solid/load.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::solid {
namespace closed_form_test {

using namespace test;

/// Lateral stretch b of a neo-Hookean bar at axial stretch a with free sides: λ ln J + μ(b² − 1) = 0, with J = a b in
/// plane strain and a b² in space. Solved by bisection.
double lateral_stretch(const NeoHookean& material, double a, int dimension) {
  double low = 0.1, high = 3;
  for (int i = 0; i < 200; ++i) {
    const double b = 0.5 * (low + high);
    const double log_j = std::log(a) + (dimension - 1) * std::log(b);
    (material.lambda * log_j + material.mu * (b * b - 1) > 0 ? high : low) = b;
  }
  return 0.5 * (low + high);
}

template <int D> void uniaxial(const Body<D>& bar, double length, double section, double stretch) {
  std::map<int, double> prescribed;
  prescribe(
      bar, "west", 0, [](const Vec<D>&) { return 0.0; }, prescribed);
  prescribe(
      bar, "east", 0, [&](const Vec<D>&) { return (stretch - 1) * length; }, prescribed);
  prescribe(
      bar, "south", 1, [](const Vec<D>&) { return 0.0; }, prescribed);
  if (D == 3)
    prescribe(
        bar, "front", D - 1, [](const Vec<D>&) { return 0.0; }, prescribed);
  VectorX u;
  const Assembled at = equilibrate(bar, prescribed, 12, u);
  ASSERT_FALSE(at.inversion);

  const NeoHookean material{bar.material().constants()};
  const double b = lateral_stretch(material, stretch, D);
  Mat<D> f = b * Mat<D>::Identity();
  f(0, 0) = stretch;
  EXPECT_LT((u - affine<D>(bar, f)).norm(), 1e-10 * u.norm());
  // P₁₁ = μ a + (λ ln J − μ)/a
  const double log_j = std::log(stretch) + (D - 1) * std::log(b);
  const double stress = material.mu * stretch + (material.lambda * log_j - material.mu) / stretch;
  double pull = 0;
  for (int a : bar.space().face_functions(nurbs::side_of("east", D))) pull += at.force(D * a);
  EXPECT_NEAR(pull, stress * section, 1e-10 * std::abs(stress * section));
}

TEST(ClosedForm, UniaxialTensionInPlaneStrain) {
  for (double stretch : {0.6, 1.4, 2.0})
    uniaxial<2>(
        make_body<2>(nurbs::rectangle(2, 0.5, Eigen::Vector2d(0, 0)), {3, 2}, "N2-N2.1", "north", neo_hookean(3, 0.35)),
        2, 0.5, stretch);
}

TEST(ClosedForm, UniaxialTensionInSpace) {
  uniaxial<3>(make_body<3>(nurbs::block({2, 0.5, 0.4}, Eigen::Vector3d(0, 0, 0)), {2, 1, 1}, "N2", "back",
                           neo_hookean(3, 0.35)),
              2, 0.5 * 0.4, 1.5);
}

/// P₁₁ at axial stretch a without lateral displacement: neo-Hooke μ a + (λ ln a − μ)/a, Hooke (λ + 2μ)(a − 1).
double confined_stress(const Material& material, double a) {
  const ElasticConstants& law = material.constants();
  return material.linear() ? (law.lambda + 2 * law.mu) * (a - 1) : law.mu * a + (law.lambda * std::log(a) - law.mu) / a;
}

/// A confined block is compressed or stretched by a dead load on a side that crosses the layer: strain and energy
/// density are uniform, and the reaction at the other end balances the load.
TEST(ClosedForm, ConfinedCompressionInSpaceByALoadAcrossALayer) {
  const nurbs::Patch block = nurbs::block({2, 0.5, 0.4}, Eigen::Vector3d(0, 0, 0));
  const double section = 0.5 * 0.4, volume = 2 * section;
  for (const Material& material : {Material(neo_hookean(3, 0.35)), Material(linear_elastic(3, 0.35))})
    for (const char* label : {"N2", "N2-N2.2"})
      for (double stretch : {0.7, 1.2}) {
        const Body<3> bar = make_body<3>(block, {2, 1, 2}, label, "back", material);
        std::map<int, double> prescribed;
        const auto fix = [&](const char* face, int component) {
          prescribe(
              bar, face, component, [](const Vec<3>&) { return 0.0; }, prescribed);
        };
        fix("west", 0);
        for (const char* face : {"south", "north"}) fix(face, 1);
        for (const char* face : {"front", "back"}) fix(face, 2);
        const double stress = confined_stress(material, stretch);
        const nurbs::Side east = nurbs::side_of("east", 3);
        const VectorX load =
            stretch < 1 ? VectorX(-stress * pressure_load(bar, east)) : VectorX(stress * traction_load(bar, east, 0));
        VectorX u;
        const Assembled at = equilibrate(bar, prescribed, 12, u, load);
        ASSERT_FALSE(at.inversion);
        const Mat<3> f = Vec<3>(stretch, 1, 1).asDiagonal();
        EXPECT_LT((u - affine<3>(bar, f)).norm(), 1e-12 * u.norm()) << label;
        EXPECT_NEAR(stored_energy(bar, u.data()), volume * material.energy(f), 1e-12);
        double pull = 0;
        for (int a : bar.space().face_functions(nurbs::side_of("west", 3))) pull += at.force(3 * a);
        EXPECT_NEAR(pull, -stress * section, 1e-12);
      }
}

/// Lamé's ring in plane strain, u_r = A r + B/r, at strains so small that neo-Hooke equals Hooke: relative error of the
/// stress in L₂.
double ring_stress_error(int elements) {
  const double inner = 1, outer = 2, a = 2e-7, b = -3e-7;
  const NeoHookean material = neo_hookean(1, 0.3);
  const Body<2> ring = make_body<2>(nurbs::quarter_annulus(inner, outer, Eigen::Vector2d(0, 0), 0),
                                    {elements, elements}, "N2", "south", material, 2);
  // The displacement of the control points of a circle follows from that of the circle: u = (A + B/r²) X.
  std::map<int, double> prescribed;
  for (int c = 0; c < 2; ++c) {
    prescribe(
        ring, "south", c, [&](const Vec<2>& x) { return (a + b / (outer * outer)) * x(c); }, prescribed);
    prescribe(
        ring, "north", c, [&](const Vec<2>& x) { return (a + b / (inner * inner)) * x(c); }, prescribed);
  }
  prescribe(
      ring, "west", 1, [](const Vec<2>&) { return 0.0; }, prescribed);
  prescribe(
      ring, "east", 0, [](const Vec<2>&) { return 0.0; }, prescribed);
  VectorX u;
  equilibrate(ring, prescribed, 2, u);

  double error = 0, size = 0;
  for (int e = 0; e < ring.elements(); ++e) {
    const auto functions = ring.tables().functions_of(e);
    const int n = std::ssize(functions);
    for (int q = 0; q < ring.tables().element(e).points; ++q) {
      Mat<2> f = Mat<2>::Identity();
      for (int i = 0; i < 2; ++i)
        for (int k = 0; k < 2; ++k)
          for (int c = 0; c < n; ++c)
            f(i, k) += u(2 * functions[c] + i) * ring.tables().gradients_of(e)[(2 * q + k) * n + c];
      const Vec<2> x = reference_point(ring, e, q), radial = x.normalized(), hoop(-radial(1), radial(0));
      const double r2 = x.squaredNorm();
      // ε_r = A − B/r², ε_θ = A + B/r², σ = λ tr ε I + 2 μ ε
      const Mat<2> exact =
          2 * a * material.lambda * Mat<2>::Identity() +
          2 * material.mu * ((a - b / r2) * radial * radial.transpose() + (a + b / r2) * hoop * hoop.transpose());
      const Mat<2> found = Material(material).cauchy_stress(in_space<2>(f)).topLeftCorner<2, 2>();
      error += ring.tables().weights_of(e)[q] * (found - exact).squaredNorm();
      size += ring.tables().weights_of(e)[q] * exact.squaredNorm();
    }
  }
  return std::sqrt(error / size);
}

TEST(ClosedForm, StressOfLamesRingConvergesWithOrderP) {
  const double coarse = ring_stress_error(3), middle = ring_stress_error(6), fine = ring_stress_error(12);
  EXPECT_GT(std::log2(coarse / middle), 1.8);
  EXPECT_GT(std::log2(middle / fine), 1.9);
  EXPECT_LT(fine, 2e-3);
}

} // namespace closed_form_test
} // namespace signorini::solid
