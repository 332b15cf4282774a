// Thick walls under internal pressure, closed forms of Lamé: the cylinder in plane strain, the sphere as a body of
// revolution and in space. Displacements converge with order p+1.
#include "base/dense.hpp"
#include "nurbs/coincident.hpp"
#include "solid/bodies.hpp"
#include "solid/load.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace signorini::solid {
namespace lame_test {

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

/// Relative error in L₂ of a radial displacement with the exact value exact(r).
template <int D> double relative_error(const Body<D>& wall, const VectorX& u, double (*exact)(double)) {
  double error = 0, size = 0;
  for (int e = 0; e < wall.elements(); ++e) {
    const ElementQuadrature rule = element_quadrature(wall.space(), e);
    for (int q = 0; q < wall.tables().element(e).points; ++q) {
      const nurbs::ElementBasis basis = wall.space().basis(e, rule.points.col(q));
      Vec<D> found = Vec<D>::Zero();
      for (std::size_t a = 0; a < basis.functions.size(); ++a)
        found += basis.values(static_cast<int>(a)) * u.segment<D>(D * basis.functions[a]);
      const Vec<D> x = reference_point(wall, e, q), expected = exact(x.norm()) * x.normalized();
      error += wall.tables().weights_of(e)[q] * (found - expected).squaredNorm();
      size += wall.tables().weights_of(e)[q] * expected.squaredNorm();
    }
  }
  return std::sqrt(error / size);
}

/// Relative error in L₂ of the displacement of a quarter annulus of elements × elements with symmetry at both ends.
double displacement_error(Kind kind, double (*exact)(double), int degree, int elements) {
  const nurbs::Patch quarter = nurbs::quarter_annulus(inner, outer, Eigen::Vector2d(0, 0), 270);
  const Body<2> plane =
      make_body<2>(quarter, {elements, elements}, text("N", degree), "north", linear_elastic(modulus, ratio), degree);
  const Body<2> wall(plane.shared_space(), plane.material(), kind);
  std::map<int, double> prescribed;
  prescribe(
      wall, "west", 0, [](const Vec<2>&) { return 0.0; }, prescribed);
  prescribe(
      wall, "east", 1, [](const Vec<2>&) { return 0.0; }, prescribed);
  VectorX u;
  equilibrate(wall, prescribed, 1, u, pressure * pressure_load(wall, nurbs::side_of("north", 2)));

  return relative_error(wall, u, exact);
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

/// Relative error in L₂ for a spherical octant in space, with `elements` per direction. The coincident control points
/// at the pole share their displacements.
double octant_error(int degree, int elements) {
  const Body<3> wall =
      make_body<3>(nurbs::sphere_octant(inner, outer, Eigen::Vector3d(0, 0, 0)), {elements, elements, elements},
                   text("N", degree), "back", linear_elastic(modulus, ratio), degree);
  std::vector<int> unknown(static_cast<std::size_t>(3 * wall.functions()), 0);
  const auto at = [&](int dof) -> int& { return unknown[dof]; };
  for (const auto& [face, component] : {std::pair("west", 1), std::pair("east", 0), std::pair("south", 2)})
    for (int a : wall.space().face_functions(nurbs::side_of(face, 3))) at(3 * a + component) = -1;
  const auto poles = nurbs::coincident_functions(wall.space());
  EXPECT_EQ(poles.size(), static_cast<std::size_t>(elements + degree));
  int count = 0;
  for (int& i : unknown)
    if (i == 0) i = count++;
  for (const std::vector<int>& pole : poles)
    for (int c = 0; c < 3; ++c)
      for (int a : pole) at(3 * a + c) = c == 2 ? at(3 * pole.front() + c) : -1;

  const Assembled rest = assemble(wall, VectorX(VectorX::Zero(3 * wall.functions())));
  const VectorX load = pressure * pressure_load(wall, nurbs::side_of("back", 3));
  MatrixX tangent = MatrixX::Zero(count, count);
  VectorX force = VectorX::Zero(count);
  for (int i = 0; i < load.size(); ++i) {
    if (at(i) < 0) continue;
    force(at(i)) += load(i);
    for (int j = 0; j < load.size(); ++j)
      if (at(j) >= 0) tangent(at(i), at(j)) += rest.tangent(i, j);
  }
  // Eliminated unknowns of the pole's points have empty rows.
  for (int i = 0; i < count; ++i)
    if (tangent(i, i) == 0) tangent(i, i) = 1;
  const VectorX found = dense::solve(tangent, force);
  VectorX u(load.size());
  for (int i = 0; i < u.size(); ++i) u(i) = at(i) < 0 ? 0 : found(at(i));
  return relative_error(wall, u, sphere);
}

TEST(Lame, SphereInSpaceConvergesWithOrderPPlus1) {
  const double coarse = octant_error(2, 2), middle = octant_error(2, 4), fine = octant_error(2, 6);
  std::printf("Lame's sphere in space, N2: %.3e %.3e %.3e, rates %.2f %.2f\n", coarse, middle, fine,
              std::log2(coarse / middle), std::log(middle / fine) / std::log(1.5));
  EXPECT_GT(std::log2(coarse / middle), 2.5);
  EXPECT_GT(std::log(middle / fine) / std::log(1.5), 2.75);
  EXPECT_LT(fine, 4e-5);
  const double few = octant_error(3, 2), more = octant_error(3, 4);
  std::printf("N3: %.3e %.3e, rate %.2f\n", few, more, std::log2(few / more));
  EXPECT_GT(std::log2(few / more), 3.5);
}

} // namespace lame_test
} // namespace signorini::solid
