// Thick walls under inner pressure, the closed forms of Lamé: the cylinder in plane strain, the sphere as a body of
// revolution. Displacements converge with order p+1.
#include "solid/bodies.hpp"
#include "solid/load.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::solid {
namespace {

using namespace test;

constexpr double inner = 1, outer = 1.5, modulus = 3, ratio = 0.3, pressure = 0.2;

/// u_r = (1+ν)/E p a²/(b²−a²) [(1−2ν) r + b²/r]
double cylinder(double r) {
  return (1 + ratio) / modulus * pressure / (outer * outer / (inner * inner) - 1) *
         ((1 - 2 * ratio) * r + outer * outer / r);
}

/// u_r = p/E a³/(b³−a³) [(1−2ν) r + (1+ν) b³/(2r²)]
double sphere(double r) {
  const double cube = std::pow(outer, 3);
  return pressure / modulus / (cube / std::pow(inner, 3) - 1) *
         ((1 - 2 * ratio) * r + (1 + ratio) * cube / (2 * r * r));
}

/// Relative error of the displacement in L₂ of a quarter annulus of elements × elements, symmetric at both ends.
double displacement_error(Kind kind, double (*exact)(double), int degree, int elements) {
  const nurbs::Patch quarter = nurbs::quarter_annulus(inner, outer, Eigen::Vector2d(0, 0), 270);
  const Body<2> plane =
      make_body<2>(quarter, {elements, elements}, text("N", degree), "north", linear_elastic(modulus, ratio), degree);
  const Body<2> wall(plane.shared_space(), plane.material(), kind);
  std::map<int, double> held;
  prescribe(
      wall, "west", 0, [](const Vec<2>&) { return 0.0; }, held);
  prescribe(
      wall, "east", 1, [](const Vec<2>&) { return 0.0; }, held);
  VectorX u;
  equilibrate(wall, held, 1, u, pressure * pressure_load(wall, nurbs::side_of("north", 2)));

  double error = 0, size = 0;
  for (int e = 0; e < wall.elements(); ++e) {
    const ElementQuadrature rule = element_quadrature(wall.space(), e);
    for (int q = 0; q < wall.element(e).points; ++q) {
      const nurbs::ElementBasis basis = wall.space().basis(e, rule.points.col(q));
      Vec<2> found = Vec<2>::Zero();
      for (std::size_t a = 0; a < basis.functions.size(); ++a)
        found += basis.values(static_cast<int>(a)) * u.segment<2>(2 * basis.functions[a]);
      const Vec<2> x = wall.reference_point(e, q), expected = exact(x.norm()) * x.normalized();
      error += wall.weights_of(e)[q] * (found - expected).squaredNorm();
      size += wall.weights_of(e)[q] * expected.squaredNorm();
    }
  }
  return std::sqrt(error / size);
}

void converges_with_order_p_plus_1(Kind kind, double (*exact)(double), double quadratic, double cubic) {
  for (int degree : {2, 3}) {
    const double coarse = displacement_error(kind, exact, degree, 4),
                 middle = displacement_error(kind, exact, degree, 8),
                 fine = displacement_error(kind, exact, degree, 16);
    EXPECT_GT(std::log2(coarse / middle), degree + 0.75);
    EXPECT_GT(std::log2(middle / fine), degree + 0.85);
    EXPECT_LT(fine, degree == 2 ? quadratic : cubic);
  }
}

TEST(Lame, CylinderConvergesWithOrderPPlus1) {
  converges_with_order_p_plus_1(Kind::plane_strain, cylinder, 5e-7, 1e-8);
}
TEST(Lame, SphereConvergesWithOrderPPlus1) {
  converges_with_order_p_plus_1(Kind::axisymmetric, sphere, 2e-6, 5e-8);
}

} // namespace
} // namespace signorini::solid
