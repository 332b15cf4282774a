#pragma once
// Cones around the normals of a part of a face, by which searches leave out parts that look the same way as a point
// (Volino, Magnenat-Thalmann: Efficient self-collision detection, Comput. Graph. Forum 13, 1994).

#include "contact/face/bezier_element.hpp"

namespace signorini::contact {

/// All directions within `half` (radians) of a unit vector; from π on all directions at all.
template <int D> struct NormalCone {
  Vec<D> axis = Vec<D>::Unit(0);
  double half = pi;

  static constexpr double pi = 3.14159265358979323846;
};

/// A cone around the outward normals of an element, from the bounds on its derivatives.
template <int D> NormalCone<D> normal_cone(const DerivativeBounds<D>& bounds, double orientation);
/// A cone around two others.
template <int D> NormalCone<D> joined(const NormalCone<D>& one, const NormalCone<D>& other);

} // namespace signorini::contact
