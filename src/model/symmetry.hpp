#pragma once
// Planes in which a scene is its own mirror image: half of it would do.

#include "model/model.hpp"

namespace signorini::model {

/// How exactly a scene must repeat: lengths against its size, cosines and weights against 1. For revolution.hpp, too.
constexpr double symmetry_tolerance = 1e-9;

/// A plane x = c, y = c or z = c.
struct Mirror {
  int axis;                    ///< component along its normal
  double place;                ///< c
  std::vector<int> directions; ///< per body: the parametric direction that it turns round
  std::vector<int> driven;     ///< supports that drive along the normal: only while they do not is it a mirror
};

/// The planes through the middle of the bodies, normal to an axis, that map everything onto itself: every body's
/// control points, weights and knots (each body onto itself), supports, loads, contacts
/// with their points, and obstacles. What turns, or has moved along the normal, breaks the symmetry; so may a path. In
/// an axisymmetric scene only planes across the axis are looked at.
template <int D> std::vector<Mirror> find_mirrors(const Model<D>& model);

/// Unknowns of the part on one side of all these planes, which hold what moves through them.
template <int D> int unknowns_beside(const Model<D>& model, const std::vector<Mirror>& mirrors);

} // namespace signorini::model
