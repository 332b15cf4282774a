#include "contact/rigid/obstacle.hpp"

#include "base/error.hpp"
#include "contact/closest/chord.hpp"
#include "contact/rigid/near_point.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

namespace signorini::contact {

namespace {

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

template <int D> FaceCoordinates<D> closest(const Plane<D>& plane, const Vec<D>& x) {
  const auto directions = across(plane.normal);
  FaceCoordinates<D> xi;
  for (int a = 0; a < D - 1; ++a) xi(a) = directions[a].dot(x);
  return xi;
}

template <int D> void locate(const Plane<D>& plane, FaceGeometry<D>& point) {
  point.tangent = across(plane.normal);
  point.position = plane.normal.dot(plane.point) * plane.normal;
  for (int a = 0; a < D - 1; ++a) point.position += point.xi(a) * point.tangent[a];
  for (auto& second : point.second) second.setZero();
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template Plane<D> make_plane(const Vec<D>&, const Vec<D>&);                                                          \
  template Ball<D> make_ball(const Vec<D>&, double, bool);                                                             \
  template FaceCoordinates<D> closest(const Plane<D>&, const Vec<D>&);                                                 \
  template void locate(const Plane<D>&, FaceGeometry<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

FaceCoordinates<2> closest(const Ball<2>& ball, const Vec<2>& x) {
  const NearPoint<2> near = near_point<2>(ball.center, ball.radius, Vec<2>::UnitX());
  const double angle = angle_at(ball.radius, Vec<2>(x - near.point), across(near.normal)[0], near.normal);
  return FaceCoordinates<2>(ball.hollow ? -angle : angle);
}

void locate(const Ball<2>& ball, FaceGeometry<2>& point) {
  const NearPoint<2> near = near_point<2>(ball.center, ball.radius, Vec<2>::UnitX());
  const double sign = ball.hollow ? -1 : 1;
  const Vec<2> way = along_circle(ball.radius, sign * point.xi(0), across(near.normal)[0], near.normal),
               out = ball.radius * near.normal + way;
  point.position = near.point + way;
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

namespace {

/// A point near the contact, and unit vectors there: outward and along the circle about the axis.
struct CylinderFrame {
  Vec<3> point, out, around;
};

CylinderFrame cylinder_frame(const Cylinder& cylinder) {
  const NearPoint<3> near =
      near_point<3>(normal_part(cylinder.point, cylinder.axis), cylinder.radius, across(cylinder.axis)[0]);
  return {near.point, near.normal, cylinder.axis.cross(near.normal)};
}

/// Unit vectors and the point nearest to the contact of a torus, its distance from the axis, and the outward normal of
/// the tube there, with components along `out` and the axis.
struct TorusFrame {
  Vec<3> point, out, around;
  double distance;
  Vec<2> normal;
};

TorusFrame torus_frame(const Torus& torus) {
  // The circle of the tube's center about the axis has a point near the contact, and so has the tube around it.
  const Vec<3> usual = across(torus.axis)[0];
  const NearPoint<3> ring = near_point<3>(normal_part(torus.center, torus.axis), torus.ring, usual);
  const Vec<2> center(ring.normal.dot(ring.point), torus.axis.dot(torus.center));
  const NearPoint<2> tube = near_point<2>(center, torus.radius, Vec<2>::UnitX());
  const Vec<3> on_axis = ring.point - center(0) * ring.normal;
  return {on_axis + tube.point(0) * ring.normal + tube.point(1) * torus.axis, ring.normal,
          torus.axis.cross(ring.normal), torus.ring + torus.radius * tube.normal(0), tube.normal};
}

} // namespace

FaceCoordinates<3> closest(const Ball<3>& ball, const Vec<3>& x) {
  const NearPoint<3> near = near_point<3>(ball.center, ball.radius, Vec<3>::UnitZ());
  const auto [a, b] = across(near.normal);
  const Vec<3> away = x - near.point;
  const double first = a.dot(away), second = b.dot(away);
  return {std::atan2(second, first), std::atan2(std::hypot(first, second), ball.radius + near.normal.dot(away))};
}

FaceCoordinates<3> closest(const Cylinder& cylinder, const Vec<3>& x) {
  const CylinderFrame frame = cylinder_frame(cylinder);
  const Vec<3> away = x - frame.point;
  return {angle_at(cylinder.radius, away, frame.around, frame.out), cylinder.axis.dot(away)};
}

FaceCoordinates<3> closest(const Torus& torus, const Vec<3>& x) {
  const TorusFrame frame = torus_frame(torus);
  const Vec<3> away = x - frame.point;
  const double out = frame.out.dot(away), around = frame.around.dot(away);
  // From the near point's distance L from the axis to that of x: (L + o)² + s² − L² = o (2 L + o) + s²
  const double distance = std::hypot(frame.distance + out, around);
  const Vec<2> in_plane((out * (2 * frame.distance + out) + around * around) / (distance + frame.distance),
                        torus.axis.dot(away));
  return {std::atan2(around, frame.distance + out),
          angle_at(torus.radius, in_plane, across(frame.normal)[0], frame.normal)};
}

void locate(const Ball<3>& ball, FaceGeometry<3>& point) {
  const NearPoint<3> near = near_point<3>(ball.center, ball.radius, Vec<3>::UnitZ());
  const auto [a, b] = across(near.normal);
  const double azimuth = point.xi(0), polar = point.xi(1);
  const Vec<3> around = std::cos(azimuth) * b - std::sin(azimuth) * a;
  const Vec<3> aside = std::cos(azimuth) * a + std::sin(azimuth) * b;
  const Vec<3> down = std::cos(polar) * aside - std::sin(polar) * near.normal;
  const Vec<3> out = down.cross(around);
  point.position = near.point + along_circle(ball.radius, polar, aside, near.normal);
  // Arc lengths over R along `down` and `around`: x,11 = x,22 = −R n, x,12 = 0 at the point
  point.tangent = {ball.radius * down, ball.radius * around};
  point.second = {-ball.radius * out, Vec<3>::Zero(), -ball.radius * out};
  turn_if(ball.hollow, point);
}

void locate(const Cylinder& cylinder, FaceGeometry<3>& point) {
  const CylinderFrame frame = cylinder_frame(cylinder);
  const double c = std::cos(point.xi(0)), s = std::sin(point.xi(0));
  const Vec<3> out = c * frame.out + s * frame.around;
  point.position =
      frame.point + along_circle(cylinder.radius, point.xi(0), frame.around, frame.out) + point.xi(1) * cylinder.axis;
  point.tangent = {cylinder.radius * (c * frame.around - s * frame.out), cylinder.axis};
  point.second = {-cylinder.radius * out, Vec<3>::Zero(), Vec<3>::Zero()};
  turn_if(cylinder.hollow, point);
}

void locate(const Torus& torus, FaceGeometry<3>& point) {
  const TorusFrame frame = torus_frame(torus);
  const double c = std::cos(point.xi(0)), s = std::sin(point.xi(0));
  const Vec<3> out = c * frame.out + s * frame.around, around = c * frame.around - s * frame.out;
  const Vec<2> way = along_circle(torus.radius, point.xi(1), across(frame.normal)[0], frame.normal);
  const double along = torus.radius * frame.normal(0) + way(0), up = torus.radius * frame.normal(1) + way(1);
  // x = c + (R + r cos ψ) e(φ) + r sin ψ a, measured from the near point
  point.position = frame.point + along_circle(frame.distance, point.xi(0), frame.around, frame.out) + way(0) * out +
                   way(1) * torus.axis;
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
  const Vec<3> chord = to.position - from.position;
  if (!(chord.norm() > length)) return slip;
  // Along the great circle; a chord of length L spans the angle 2 asin(L/2R).
  const Vec<3> normal = normal_of<3>(from.tangent).normalized() * (ball.hollow ? -1 : 1);
  const double angle = 2 * std::asin(std::min(1.0, length / (2 * ball.radius)));
  return closest(ball,
                 from.position + along_circle(ball.radius, angle, normal_part(chord, normal).normalized(), normal));
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
