#include "nurbs/several_patches.hpp"

#include "base/error.hpp"
#include "nurbs/constructions.hpp"
#include "nurbs/curves.hpp"
#include "nurbs/directions.hpp"
#include "nurbs/refine.hpp"
#include "nurbs/shape_parts.hpp"
#include "nurbs/shapes.hpp"

#include <cmath>

namespace signorini::nurbs {

namespace {

/// Distance of the core's corners from the center per radius: along a diagonal core and outer patch are equally thick.
constexpr double core_share = 0.5;

constexpr Side outer_in_plane{1, false}, outer_in_space{2, false};

/// All directions elevated to one degree.
Patch elevated(Patch patch, int degree) {
  for (int d = 0; d < patch.parametric_dimension(); ++d)
    patch = elevate(patch, d, degree - patch.direction(d).degree());
  return patch;
}

Boundary boundary(const char* name, int patches, Side side) {
  Boundary result{name, {}};
  for (int n = 0; n < patches; ++n) result.faces.push_back({n, side});
  return result;
}

/// Product of two polynomials of degree 2 × 2 in Bernstein form, of degree 4 × 4.
VectorX product(const VectorX& a, const VectorX& b) {
  constexpr double binomial2[] = {1, 2, 1}, binomial4[] = {1, 4, 6, 4, 1};
  VectorX result = VectorX::Zero(25);
  for (int n = 0; n < 9; ++n)
    for (int m = 0; m < 9; ++m) {
      const int i = n % 3, j = n / 3, k = m % 3, l = m / 3;
      const double factor = binomial2[i] * binomial2[j] * binomial2[k] * binomial2[l];
      result(i + k + 5 * (j + l)) += factor / (binomial4[i + k] * binomial4[j + l]) * a(n) * b(m);
    }
  return result;
}

/// The lowest sixth of the unit sphere, which its intersections with the planes x = ±z and y = ±z bound, ξ¹ towards x,
/// ξ² towards y; corners have weight 1. The stereographic projection from (0, 0, 1) to z = 0 maps these great circles
/// to circles of radius √2 about (±1, 0) and (0, ±1), so a sixth is the image of a biquadratic Coons patch of four arcs
/// of 30° (J. E. Cobb, Tiling the sphere with rational Bézier patches, University of Utah, UUCS-88-009, 1988).
Patch sphere_sixth() {
  const auto side = [](double x, double y, double start, double stop) {
    return arc(Vec<2>(x, y), std::sqrt(2.0), start, stop);
  };
  const Patch plane = coons({side(1, 0, 195, 165), side(-1, 0, -15, 15), side(0, 1, 255, 285), side(0, -1, 105, 75)});
  const VectorX u = plane.homogeneous().row(0), v = plane.homogeneous().row(1), w = plane.homogeneous().row(2);
  // (u, v) ↦ (2u, 2v, u² + v² − 1)/(u² + v² + 1)
  const VectorX squares = product(u, u) + product(v, v), ones = product(w, w);
  MatrixX homogeneous(4, 25);
  homogeneous << 2 * product(u, w).transpose(), 2 * product(v, w).transpose(), (squares - ones).transpose(),
      (squares + ones).transpose();
  return {{KnotVector::single(4), KnotVector::single(4)}, homogeneous / homogeneous(3, 0)};
}

/// The lowest of the outer patches of the ball about the origin.
Patch lowest_part(double radius) {
  const double half = core_share * radius / std::sqrt(3.0);
  const Patch sphere = scale(sphere_sixth(), Vec<3>::Constant(radius), Vec<3>::Zero());
  return ruled(sphere, translate(to_space(rectangle(2 * half, 2 * half, Vec<2>(-half, -half))), Vec<3>(0, 0, -half)));
}

} // namespace

SeveralPatches disc(double radius, const Point& center) {
  check_radius("radius", radius, center, 2);
  const auto corner = [&](double angle) { return Point(core_share * radius * direction_of(angle)); };
  SeveralPatches result{{}, {boundary("outer", 4, outer_in_plane)}};
  for (const double start : {225, 315, 45, 135}) {
    const Patch outer = arc(Point::Zero(2), radius, start, start + 90);
    result.patches.push_back(ruled(outer, line(corner(start), corner(start + 90))));
  }
  const Patch south = line(corner(225), corner(315)), north = line(corner(135), corner(45));
  result.patches.push_back(elevated(ruled(south, north), 2));
  for (Patch& patch : result.patches) patch = translate(patch, center);
  return result;
}

SeveralPatches cylinder(double radius, double width, const Point& center) {
  check_radius("radius", radius, center, 3);
  check_length("width", width);
  SeveralPatches result = disc(radius, Point::Zero(2));
  for (Patch& patch : result.patches)
    patch = swap_directions(extrude(upright(patch, center), Vec<3>(0, width, 0)), 1, 2);
  result.boundaries = {boundary("outer", 4, outer_in_space), boundary("south", 5, {1, false}),
                       boundary("north", 5, {1, true})};
  return result;
}

SeveralPatches torus(double radius, double section, const Point& center) {
  check_radius("radius", radius, center, 3);
  check_radius("section", section, center, 3);
  require(section < radius, "nurbs.shapes.torus", {{"section", section}, {"radius", radius}});
  SeveralPatches result = disc(section, Point::Zero(2));
  for (Patch& patch : result.patches) {
    const Patch around = revolve(upright(patch, Vec<3>(radius, 0, 0)), Vec<3>::Zero(), Vec<3>::UnitZ(), 360);
    patch = translate(swap_directions(around, 1, 2), center);
  }
  result.boundaries = {boundary("outer", 4, outer_in_space)};
  return result;
}

SeveralPatches ball(double radius, const Point& center) {
  check_radius("radius", radius, center, 3);
  const Point origin = Vec<3>::Zero();
  const Patch lowest = lowest_part(radius), right = rotate(lowest, -90, origin, Vec<3>::UnitY());
  SeveralPatches result{{lowest}, {boundary("outer", 6, outer_in_space)}};
  for (const double angle : {0, 90, 180, 270}) result.patches.push_back(rotate(right, angle, origin, Vec<3>::UnitZ()));
  result.patches.push_back(rotate(lowest, 180, origin, Vec<3>::UnitX()));
  const double half = core_share * radius / std::sqrt(3.0);
  result.patches.push_back(elevated(block({2 * half, 2 * half, 2 * half}, Vec<3>::Constant(-half)), 4));
  for (Patch& patch : result.patches) patch = translate(patch, center);
  return result;
}

} // namespace signorini::nurbs
