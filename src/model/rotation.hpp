#pragma once
// Rotation of a vector about an axis.

#include "base/eigen.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace signorini::model {

/// R(θ) r by an angle θ in radians, in 3D about a unit vector (unused in 2D); or a derivative with respect to θ, of
/// order 1 by R′ = R(θ + 90°) normal to the axis, of order 2 by R″ = −R normal to the axis.
template <int D> Vec<D> rotated(double angle, const Vec<D>& axis, const Vec<D>& r, int derivative = 0) {
  const double c = std::cos(angle), s = std::sin(angle);
  if constexpr (D == 2) {
    const Vec<2> quarter(-r(1), r(0));
    if (derivative == 2) return -(c * r + s * quarter);
    return derivative ? Vec<2>(c * quarter - s * r) : Vec<2>(c * r + s * quarter);
  } else {
    // Rodrigues: R r = a (a·r) + cos θ (r − a (a·r)) + sin θ a × r
    const Vec<3> along = axis * axis.dot(r), across = r - along, quarter = axis.cross(r);
    if (derivative == 2) return -(c * across + s * quarter);
    return derivative ? Vec<3>(c * quarter - s * across) : Vec<3>(along + c * across + s * quarter);
  }
}

} // namespace signorini::model
