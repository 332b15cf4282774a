#pragma once
// Points of round shapes from which positions are measured, so that a far center causes no rounding errors.
//
// With x̄ = c + R n positions and gaps would have errors of ε R, however small a body next to a large shape is. Measured
// from a point a of the shape with normal n, at which the circle has the direction t, the closest point to x is
//     x̄ = a + R (sin θ t − 2 sin²(θ/2) n),   tan θ = d·t / (R + d·n),   d = x − a,
// with errors of ε |d|. The point a of the shape closest to the origin serves all bodies: a point that touches the
// shape is at least as far from the origin, and its coordinates have errors of ε |x|. For the same reason ξ, an angle
// from a, distinguishes slip points as coordinates do.

#include "base/eigen.hpp"

#include <array>
#include <cmath>

namespace signorini::contact {

/// The direction that, rotated by −90°, is the normal.
inline std::array<Vec<2>, 1> across(const Vec<2>& normal) {
  return {Vec<2>(-normal(1), normal(0))};
}

/// Unit vectors a, b with a × b = axis; a is built from the coordinate axis with the largest angle to `axis`.
inline std::array<Vec<3>, 2> across(const Vec<3>& axis) {
  int least;
  axis.cwiseAbs().minCoeff(&least);
  const Vec<3> first = (Vec<3>::Unit(least) - axis(least) * axis).normalized();
  return {first, axis.cross(first)};
}

/// The part of a vector normal to a unit vector; twice, since a vector almost along it leaves mostly rounding error.
inline Vec<3> normal_part(const Vec<3>& vector, const Vec<3>& direction) {
  const Vec<3> part = vector - direction.dot(vector) * direction;
  return part - direction.dot(part) * direction;
}

template <int D> struct NearPoint {
  Vec<D> point, normal; ///< outward
};

/// The point of a circle or sphere closest to the origin or, where its center is closer, in the direction `usual`. The
/// center of a circle in space is that on the plane through the origin. Exact but for one rounding: a shape that
/// touches the origin by the numbers given does so here.
template <int D> NearPoint<D> near_point(const Vec<D>& center, double radius, const Vec<D>& usual);

/// The angle θ above.
template <class Vector> double angle_at(double radius, const Vector& away, const Vector& across, const Vector& normal) {
  return std::atan2(across.dot(away), radius + normal.dot(away));
}

/// x̄ − a at an angle θ.
template <class Vector> Vector along_circle(double radius, double angle, const Vector& across, const Vector& normal) {
  const double half = std::sin(angle / 2);
  return radius * std::sin(angle) * across - 2 * radius * half * half * normal;
}

} // namespace signorini::contact
