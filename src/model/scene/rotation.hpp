#pragma once
// Rotation of a vector about an axis.

#include "base/eigen.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace signorini::model {

/// Derivatives of R(θ) r, rotated by an angle θ in radians, in 3D about a unit vector (unused in 2D): of order 1 by
/// R′ = R(θ + 90°) normal to the axis, of order 2 by R″ = −R normal to the axis.
template <int D> Vec<D> rotation_rate(double angle, const Vec<D>& axis, const Vec<D>& r, int order) {
  const double c = std::cos(angle), s = std::sin(angle);
  if constexpr (D == 2) {
    const Vec<2> quarter(-r(1), r(0));
    return order == 2 ? Vec<2>(-(c * r + s * quarter)) : Vec<2>(c * quarter - s * r);
  } else {
    // Rodrigues: R r = a (a·r) + cos θ (r − a (a·r)) + sin θ a × r
    const Vec<3> across = r - axis * axis.dot(r), quarter = axis.cross(r);
    return order == 2 ? Vec<3>(-(c * across + s * quarter)) : Vec<3>(c * quarter - s * across);
  }
}

/// R(θ) r − r without the rounding errors of R(θ) r, which are those of a large r: cos θ − 1 = −2 sin²(θ/2).
template <int D> Vec<D> turned(double angle, const Vec<D>& axis, const Vec<D>& r) {
  const double half = std::sin(angle / 2), less = -2 * half * half, s = std::sin(angle);
  if constexpr (D == 2)
    return less * r + s * Vec<2>(-r(1), r(0));
  else
    return less * (r - axis * axis.dot(r)) + s * axis.cross(r);
}

} // namespace signorini::model
