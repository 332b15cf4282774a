#include "nurbs/shapes.hpp"

#include "base/error.hpp"
#include "base/orthonormal.hpp"
#include "nurbs/basis.hpp"
#include "nurbs/directions.hpp"
#include "nurbs/refine.hpp"
#include "nurbs/shape_parts.hpp"

#include <cmath>

namespace signorini::nurbs {

namespace {

/// The part of an annulus from angle `start` to `stop`, ξ² from the outer to the inner radius.
Patch annulus(double inner, double outer, const Point& center, double start, double stop) {
  check_point("center", center, 2);
  check_radii(inner, outer);
  return ruled(arc(center, outer, start, stop), arc(center, inner, start, stop));
}

/// A pipe along y: the part of its section from angle `start` to `stop` in the x-z plane; ξ¹ along the arc, ξ² along y,
/// ξ³ from the outer to the inner radius.
Patch pipe(double inner, double outer, double width, const Point& center, double start, double stop) {
  check_radii(inner, outer);
  check_length("width", width);
  check_point("center", center, 3);
  const auto shell = [&](double radius) {
    return extrude(upright(arc(Point::Zero(2), radius, start, stop), center), Vec<3>(0, width, 0));
  };
  return ruled(shell(outer), shell(inner));
}

/// A volume or a plane surface from `outer`, where the new last direction starts, to points: to `foot`(x) of each
/// control point x, with its weight. The face at its end is singular.
template <class Foot> Patch converging(const Patch& outer, Foot foot) {
  MatrixX points = outer.points();
  for (auto point : points.colwise()) point = foot(VectorX(point));
  return ruled(outer, make_patch(outer.directions(), points, outer.weights()));
}

/// The part of a sphere about the origin: ξ¹ around the z axis from x towards y by `turn` degrees, ξ² down the meridian
/// from latitude `top` (degrees) to the lower pole.
Patch sphere_part(double radius, double turn, double top) {
  const Patch meridian = upright(arc(Point::Zero(2), radius, top, -90), Point::Zero(3));
  return swap_directions(revolve(meridian, Point::Zero(3), Vec<3>::UnitZ(), turn), 0, 1);
}

/// Values N_i(ξ_j) of the functions at their own Greville abscissae: row j, column i.
MatrixX collocation(const KnotVector& knots) {
  const std::vector<double> nodes = knots.greville();
  MatrixX result = MatrixX::Zero(knots.functions(), knots.functions());
  for (int j = 0; j < knots.functions(); ++j) {
    double values[max_degree + 1];
    const double xi = nodes[j];
    const int element = knots.find_element(xi);
    basis_derivatives(knots, element, xi, 0, values);
    for (int s = 0; s <= knots.degree(); ++s) result(j, knots.first_function(element) + s) = values[s];
  }
  return result;
}

} // namespace

Patch rectangle(double width, double height, const Point& corner) {
  check_point("corner", corner, 2);
  check_edge("width", width, "corner x", corner(0));
  check_edge("height", height, "corner y", corner(1));
  return extrude(line(corner, corner + Vec<2>(width, 0)), Vec<2>(0, height));
}

Patch half_annulus(double inner, double outer, const Point& center) {
  return annulus(inner, outer, center, 180, 360);
}

Patch quarter_annulus(double inner, double outer, const Point& center, double start) {
  return annulus(inner, outer, center, start, start + 90);
}

Patch ring(double inner, double outer, const Point& center) {
  return annulus(inner, outer, center, 90, 450);
}

Patch polar_disc(double radius, const Point& center) {
  check_radius("radius", radius, center, 2);
  return converging(arc(center, radius, 90, 450), [&](const Point&) { return center; });
}

Patch hook(double length, double thickness, double nose, double land, double insertion, double retention,
           const Point& corner) {
  check_length("length", length);
  check_length("thickness", thickness);
  check_length("nose", nose);
  check_length("land", land);
  check_point("corner", corner, 2);
  require(insertion > 0 && insertion < 90, "nurbs.shapes.insertion", {{"angle", insertion}});
  require(retention > 0 && retention <= 90, "nurbs.shapes.retention", {{"angle", retention}});
  const auto run = [&](double angle) { return nose * direction_of(angle)(0) / direction_of(angle)(1); };
  const double start = length + run(retention), end = start + land, tip = end + run(insertion);
  // Below the nose the knots divide the lower side evenly: all four elements are convex for any lengths and angles.
  MatrixX lower = MatrixX::Zero(2, 5), upper = MatrixX::Constant(2, 5, thickness);
  for (int i = 1; i < 5; ++i) lower(0, i) = length + (tip - length) * i / 4;
  upper.row(0) << 0, length, start, end, tip;
  upper.row(1).segment(2, 2).array() += nose;
  const KnotVector along(1, {0, 0, lower(0, 1) / tip, lower(0, 2) / tip, lower(0, 3) / tip, 1, 1});
  return translate(ruled(make_patch({along}, lower), make_patch({along}, upper)), corner);
}

Patch block(const std::array<double, 3>& size, const Point& corner) {
  const char *const names[] = {"size x", "size y", "size z"}, *const starts[] = {"corner x", "corner y", "corner z"};
  check_point("corner", corner, 3);
  for (std::size_t i = 0; i < 3; ++i) check_edge(names[i], size[i], starts[i], corner(static_cast<Eigen::Index>(i)));
  const Patch edge = line(corner, corner + Vec<3>(size[0], 0, 0));
  return extrude(extrude(edge, Vec<3>(0, size[1], 0)), Vec<3>(0, 0, size[2]));
}

Patch half_cylinder_shell(double inner, double outer, double width, const Point& center) {
  return pipe(inner, outer, width, center, 180, 360);
}

Patch tube(double inner, double outer, double width, const Point& center) {
  return pipe(inner, outer, width, center, 90, 450);
}

Patch polar_cylinder(double radius, double width, const Point& center) {
  check_radius("radius", radius, center, 3);
  check_length("width", width);
  const Patch outer = extrude(upright(arc(Point::Zero(2), radius, 90, 450), center), Vec<3>(0, width, 0));
  return converging(outer, [&](const Point& x) { return Point(Vec<3>(center(0), x(1), center(2))); });
}

Patch polar_ball(double radius, const Point& center) {
  check_radius("radius", radius, center, 3);
  return translate(converging(sphere_part(radius, 360, 90), [](const Point&) { return Point::Zero(3); }), center);
}

Patch sphere_octant(double inner, double outer, const Point& center) {
  check_radii(inner, outer);
  check_point("center", center, 3);
  return translate(ruled(sphere_part(outer, 90, 0), sphere_part(inner, 90, 0)), center);
}

Patch hollow_hemisphere(double inner, double outer, const Point& center, Poles poles) {
  check_radii(inner, outer);
  check_point("center", center, 3);
  if (poles == Poles::bottom) return translate(ruled(sphere_part(outer, 360, 0), sphere_part(inner, 360, 0)), center);
  // Half a revolution from x over y to −x, rotated onto its side: x ↦ −x, y ↦ −z, z ↦ −y.
  const Mat<3> aside = (Mat<3>() << -1, 0, 0, 0, 0, -1, 0, -1, 0).finished();
  return transform(ruled(sphere_part(outer, 180, 90), sphere_part(inner, 180, 90)), aside, center);
}

Patch spherical_indenter(double width, double depth, double height, double radius, int elements, const Point& corner) {
  check_length("width", width);
  check_length("depth", depth);
  check_length("height", height);
  check_length("radius", radius);
  check_point("corner", corner, 3);
  require(elements >= 1, "nurbs.shapes.cap_elements", {{"elements", elements}});
  const double half_diagonal = std::hypot(width, depth) / 2;
  require(half_diagonal <= radius, "nurbs.shapes.cap_radius", {{"radius", radius}, {"least", half_diagonal}});
  const double cap = radius - std::sqrt(radius * radius - half_diagonal * half_diagonal);
  require(cap < height, "nurbs.shapes.cap_height", {{"cap", cap}, {"height", height}});

  const KnotVector single = KnotVector::single(2);
  std::vector<double> spans = element_knots(single, elements);
  spans.insert(spans.begin(), 3, 0.0);
  spans.insert(spans.end(), 3, 1.0);
  const KnotVector knots(2, std::move(spans));
  const std::vector<double> nodes = knots.greville();
  const int n = knots.functions();
  MatrixX heights(n, n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      // z = r − √(r² − Δx² − Δy²)
      const double x = (nodes[i] - 0.5) * width, y = (nodes[j] - 0.5) * depth;
      heights(i, j) = radius - std::sqrt(std::max(0.0, radius * radius - x * x - y * y));
    }
  // heights = N c Nᵀ
  const MatrixX inverse = pseudo_inverse(collocation(knots));
  const MatrixX by_rows = inverse.lazyProduct(heights);
  const MatrixX coefficients = by_rows.lazyProduct(inverse.transpose());

  // x and y are linear: their control values are the Greville abscissae.
  MatrixX points(3, 2 * n * n);
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        points.col(i + n * (j + n * k)) << nodes[i] * width, nodes[j] * depth, k == 0 ? coefficients(i, j) : height;
  return make_patch({knots, knots, KnotVector::single(1)}, points.colwise() + corner);
}

} // namespace signorini::nurbs
