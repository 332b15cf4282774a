#include "contact/obstacle.hpp"

#include "base/error.hpp"
#include "contact/chord.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

namespace signorini::contact {

namespace {

/// The direction that, rotated by −90°, is the normal.
std::array<Vec<2>, 1> across(const Vec<2>& normal) {
  return {Vec<2>(-normal(1), normal(0))};
}

/// Unit vectors a, b with a × b = axis; a is built from the coordinate axis with the largest angle to `axis`.
std::array<Vec<3>, 2> across(const Vec<3>& axis) {
  int least;
  axis.cwiseAbs().minCoeff(&least);
  const Vec<3> first = (Vec<3>::Unit(least) - axis(least) * axis).normalized();
  return {first, axis.cross(first)};
}

void check_radius(double radius) {
  require(std::isfinite(radius) && radius > 0, "contact.obstacle.radius", {{"radius", radius}});
}

void check_axis(const Vec<3>& point, const Vec<3>& axis) {
  require(point.allFinite() && axis.allFinite(), "contact.cylinder.finite");
  require(axis.norm() > 0, "contact.cylinder.axis");
}

/// The fraction t of a path with chord(t) = length, by bisection; chord(1) is longer.
template <class Chord> double fraction_at(const Chord& chord, double length) {
  double low = 0, high = 1;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (low + high) / 2;
    (chord(middle) > length ? high : low) = middle;
  }
  return low;
}

/// Turns the outward normal of a hollow shape around.
void turn_if(bool hollow, FaceGeometry<3>& point) {
  if (!hollow) return;
  std::swap(point.tangent[0], point.tangent[1]);
  std::swap(point.second[0], point.second[2]);
}

} // namespace

template <int D> Plane<D> make_plane(const Vec<D>& point, const Vec<D>& normal) {
  require(point.allFinite() && normal.allFinite(), "contact.plane.finite");
  const double length = normal.norm();
  require(length > 0, "contact.plane.normal");
  return {point, normal / length};
}

template <int D> Ball<D> make_ball(const Vec<D>& center, double radius, bool hollow) {
  require(center.allFinite(), "contact.obstacle.center");
  check_radius(radius);
  return {center, radius, hollow};
}

Cylinder make_cylinder(const Vec<3>& point, const Vec<3>& axis, double radius, bool hollow) {
  check_axis(point, axis);
  check_radius(radius);
  return {point, axis.normalized(), radius, hollow};
}

Torus make_torus(const Vec<3>& center, const Vec<3>& axis, double ring, double radius, bool hollow) {
  check_axis(center, axis);
  check_radius(radius);
  require(std::isfinite(ring) && radius < ring, "contact.torus.ring", {{"ring", ring}, {"radius", radius}});
  return {center, axis.normalized(), ring, radius, hollow};
}

template <int D> double largest_coordinate(const Obstacle<D>& obstacle) {
  return std::visit(
      [](const auto& shape) {
        using Shape = std::decay_t<decltype(shape)>;
        if constexpr (std::is_same_v<Shape, Ball<D>>)
          return shape.center.cwiseAbs().maxCoeff() + shape.radius;
        else if constexpr (std::is_same_v<Shape, Cylinder>)
          return shape.point.cwiseAbs().maxCoeff() + shape.radius;
        else if constexpr (std::is_same_v<Shape, Torus>)
          return shape.center.cwiseAbs().maxCoeff() + shape.ring + shape.radius;
        else if constexpr (std::is_same_v<Shape, Plane<D>>)
          return shape.point.cwiseAbs().maxCoeff();
        else if constexpr (std::is_same_v<Shape, LevelSet<D>>)
          return shape.compiled->mesh.points.cwiseAbs().maxCoeff();
        else
          return shape.points().cwiseAbs().maxCoeff();
      },
      obstacle);
}

template <int D> FaceCoordinates<D> closest(const Plane<D>& plane, const Vec<D>& x) {
  const auto directions = across(plane.normal);
  FaceCoordinates<D> xi;
  for (int a = 0; a < D - 1; ++a) xi(a) = directions[at(a)].dot(x - plane.point);
  return xi;
}

template <int D> void locate(const Plane<D>& plane, FaceGeometry<D>& point) {
  point.tangent = across(plane.normal);
  point.position = plane.point;
  for (int a = 0; a < D - 1; ++a) point.position += point.xi(a) * point.tangent[at(a)];
  for (auto& second : point.second) second.setZero();
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template Plane<D> make_plane(const Vec<D>&, const Vec<D>&);                                                          \
  template Ball<D> make_ball(const Vec<D>&, double, bool);                                                             \
  template double largest_coordinate<D>(const Obstacle<D>&);                                                           \
  template FaceCoordinates<D> closest(const Plane<D>&, const Vec<D>&);                                                 \
  template void locate(const Plane<D>&, FaceGeometry<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

FaceCoordinates<2> closest(const Ball<2>& ball, const Vec<2>& x) {
  const Vec<2> out = x - ball.center;
  const double angle = std::atan2(out(1), out(0));
  return FaceCoordinates<2>(ball.hollow ? -angle : angle);
}

void locate(const Ball<2>& ball, FaceGeometry<2>& point) {
  const double sign = ball.hollow ? -1 : 1;
  const Vec<2> out = ball.radius * Vec<2>(std::cos(point.xi(0)), sign * std::sin(point.xi(0)));
  point.position = ball.center + out;
  point.tangent[0] = {-sign * out(1), sign * out(0)};
  point.second[0] = -out;
}

FaceCoordinates<2> advance_slip(const Plane<2>&, const FaceCoordinates<2>& slip, const FaceGeometry<2>& foot,
                                double length) {
  const double way = slip(0) - foot.xi(0);
  return std::abs(way) > length ? FaceCoordinates<2>(foot.xi(0) + std::copysign(length, way)) : slip;
}

FaceCoordinates<2> advance_slip(const Ball<2>& ball, const FaceCoordinates<2>& slip, const FaceGeometry<2>& foot,
                                double length) {
  // Along the shorter arc; a chord of length L spans the angle 2 asin(L/2R).
  const double angle = std::remainder(slip(0) - foot.xi(0), 2 * std::numbers::pi);
  const double limit = 2 * std::asin(std::min(1.0, length / (2 * ball.radius)));
  return std::abs(angle) > limit ? FaceCoordinates<2>(foot.xi(0) + std::copysign(limit, angle)) : slip;
}

// ── 3D ───────────────────────────────────────────────────────────────────────────────────────────────────────────────

FaceCoordinates<3> closest(const Ball<3>& ball, const Vec<3>& x) {
  const Vec<3> out = x - ball.center;
  return {std::atan2(out(1), out(0)), std::atan2(std::hypot(out(0), out(1)), out(2))};
}

FaceCoordinates<3> closest(const Cylinder& cylinder, const Vec<3>& x) {
  const auto [a, b] = across(cylinder.axis);
  const Vec<3> out = x - cylinder.point;
  return {std::atan2(b.dot(out), a.dot(out)), cylinder.axis.dot(out)};
}

FaceCoordinates<3> closest(const Torus& torus, const Vec<3>& x) {
  const auto [a, b] = across(torus.axis);
  const Vec<3> out = x - torus.center;
  const double first = a.dot(out), second = b.dot(out);
  return {std::atan2(second, first), std::atan2(torus.axis.dot(out), std::hypot(first, second) - torus.ring)};
}

void locate(const Ball<3>& ball, FaceGeometry<3>& point) {
  const double azimuth = point.xi(0), polar = point.xi(1);
  const Vec<3> around(-std::sin(azimuth), std::cos(azimuth), 0);
  const Vec<3> down(std::cos(polar) * std::cos(azimuth), std::cos(polar) * std::sin(azimuth), -std::sin(polar));
  const Vec<3> out = down.cross(around);
  point.position = ball.center + ball.radius * out;
  // Arc lengths over R along `down` and `around`: x,11 = x,22 = −R n, x,12 = 0 at the point
  point.tangent = {ball.radius * down, ball.radius * around};
  point.second = {-ball.radius * out, Vec<3>::Zero(), -ball.radius * out};
  turn_if(ball.hollow, point);
}

void locate(const Cylinder& cylinder, FaceGeometry<3>& point) {
  const auto [a, b] = across(cylinder.axis);
  const double c = std::cos(point.xi(0)), s = std::sin(point.xi(0));
  const Vec<3> out = c * a + s * b;
  point.position = cylinder.point + cylinder.radius * out + point.xi(1) * cylinder.axis;
  point.tangent = {cylinder.radius * (c * b - s * a), cylinder.axis};
  point.second = {-cylinder.radius * out, Vec<3>::Zero(), Vec<3>::Zero()};
  turn_if(cylinder.hollow, point);
}

void locate(const Torus& torus, FaceGeometry<3>& point) {
  const auto [a, b] = across(torus.axis);
  const double c = std::cos(point.xi(0)), s = std::sin(point.xi(0));
  const double along = torus.radius * std::cos(point.xi(1)), up = torus.radius * std::sin(point.xi(1));
  const Vec<3> out = c * a + s * b, around = c * b - s * a;
  // x = c + (R + r cos ψ) e(φ) + r sin ψ a
  point.position = torus.center + (torus.ring + along) * out + up * torus.axis;
  point.tangent = {(torus.ring + along) * around, along * torus.axis - up * out};
  point.second = {-(torus.ring + along) * out, -up * around, -along * out - up * torus.axis};
  turn_if(torus.hollow, point);
}

FaceCoordinates<3> advance_slip(const Plane<3>&, const FaceCoordinates<3>& slip, const FaceGeometry<3>& foot,
                                double length) {
  const FaceCoordinates<3> way = slip - foot.xi;
  const double distance = way.norm();
  return distance > length ? FaceCoordinates<3>(foot.xi + (length / distance) * way) : slip;
}

FaceCoordinates<3> advance_slip(const Ball<3>& ball, const FaceCoordinates<3>& slip, const FaceGeometry<3>& foot,
                                double length) {
  FaceGeometry<3> from, to; // without the obstacle's translation
  from.xi = foot.xi;
  to.xi = slip;
  locate(ball, from);
  locate(ball, to);
  // Along the great circle; a chord of length L spans the angle 2 asin(L/2R).
  const Vec<3> a = (from.position - ball.center) / ball.radius, b = (to.position - ball.center) / ball.radius;
  const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
  const double limit = 2 * std::asin(std::min(1.0, length / (2 * ball.radius)));
  if (!(angle > limit)) return slip;
  const Vec<3> across_a = (b - a.dot(b) * a).normalized();
  return closest(ball, ball.center + ball.radius * (std::cos(limit) * a + std::sin(limit) * across_a));
}

FaceCoordinates<3> advance_slip(const Cylinder& cylinder, const FaceCoordinates<3>& slip, const FaceGeometry<3>& foot,
                                double length) {
  // Along the shorter helix; its fraction t has the chord √((2R sin(tα/2))² + (tz)²), which increases with t.
  const double angle = std::remainder(slip(0) - foot.xi(0), 2 * std::numbers::pi), height = slip(1) - foot.xi(1);
  const auto chord = [&](double t) { return std::hypot(2 * cylinder.radius * std::sin(t * angle / 2), t * height); };
  if (!(chord(1) > length)) return slip;
  const double t = fraction_at(chord, length);
  return {foot.xi(0) + t * angle, foot.xi(1) + t * height};
}

FaceCoordinates<3> advance_slip(const Torus& torus, const FaceCoordinates<3>& slip, const FaceGeometry<3>& foot,
                                double length) {
  FaceGeometry<3> from, to; // without the obstacle's translation
  from.xi = foot.xi;
  to.xi = slip;
  locate(torus, from);
  locate(torus, to);
  if (!((to.position - from.position).norm() > length)) return slip;
  if (const auto found = point_on_chord(torus, from.position, to.position, length)) return found->xi;
  // Across the tube: along the path that is straight in both angles, on the shorter way around
  const FaceCoordinates<3> way(std::remainder(slip(0) - foot.xi(0), 2 * std::numbers::pi),
                               std::remainder(slip(1) - foot.xi(1), 2 * std::numbers::pi));
  const auto chord = [&](double t) {
    to.xi = foot.xi + t * way;
    locate(torus, to);
    return (to.position - from.position).norm();
  };
  return foot.xi + fraction_at(chord, length) * way;
}

} // namespace signorini::contact
