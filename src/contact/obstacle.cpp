#include "contact/obstacle.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace signorini::contact {

namespace {

/// The plane's direction whose turn by −90° is the normal.
Vec<2> direction(const Plane<2>& plane) {
  return {-plane.normal(1), plane.normal(0)};
}

} // namespace

template <int D> Plane<D> make_plane(const Vec<D>& point, const Vec<D>& normal) {
  require(point.allFinite() && normal.allFinite(), "plane: point and normal must be finite numbers");
  const double length = normal.norm();
  require(length > 0, "normal must not be zero: it points out of the obstacle, towards the body");
  return {point, normal / length};
}

template <int D> Ball<D> make_ball(const Vec<D>& centre, double radius) {
  require(centre.allFinite(), "centre must be finite numbers");
  require(std::isfinite(radius) && radius > 0, "radius must be a positive number (length), got ", radius);
  return {centre, radius};
}

template Plane<2> make_plane<2>(const Vec<2>&, const Vec<2>&);
template Ball<2> make_ball<2>(const Vec<2>&, double);

double closest(const Plane<2>& plane, const Vec<2>& x) {
  return direction(plane).dot(x - plane.point);
}

double closest(const Ball<2>& ball, const Vec<2>& x) {
  const Vec<2> out = x - ball.centre;
  return std::atan2(out(1), out(0));
}

void locate(const Plane<2>& plane, FacePoint<2>& point) {
  point.tangent[0] = direction(plane);
  point.position = plane.point + point.xi(0) * point.tangent[0];
  point.second[0].setZero();
}

void locate(const Ball<2>& ball, FacePoint<2>& point) {
  const Vec<2> out = ball.radius * Vec<2>(std::cos(point.xi(0)), std::sin(point.xi(0)));
  point.position = ball.centre + out;
  point.tangent[0] = {-out(1), out(0)};
  point.second[0] = -out;
}

double advance_slip(const Plane<2>&, double slip, double foot, double length) {
  return std::abs(slip - foot) > length ? foot + std::copysign(length, slip - foot) : slip;
}

double advance_slip(const Ball<2>& ball, double slip, double foot, double length) {
  // The shorter way round; a chord of length L spans the angle 2 asin(L/2R).
  const double angle = std::remainder(slip - foot, 2 * std::numbers::pi);
  const double limit = 2 * std::asin(std::min(1.0, length / (2 * ball.radius)));
  return std::abs(angle) > limit ? foot + std::copysign(limit, angle) : slip;
}

} // namespace signorini::contact
