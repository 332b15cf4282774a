#pragma once
// Feet of a point of a set of faces: its distance from the set has the minimum zero, at the point itself, and others
// that do not count, such as the back of a wall [theory 8.4].

#include "contact/face/search.hpp"

#include <limits>
#include <memory>
#include <vector>

namespace signorini::contact {

/// Constant data of a set of faces, by sheet of its surface.
template <int D> struct FaceSet {
  std::vector<int> bodies;       ///< behind it; joined bodies have one number
  std::vector<double> thickness; ///< of the body behind it
  Surface<D> reference;          ///< in the reference configuration, with the elements of the moving surface
  double size;                   ///< largest distance in the reference configuration
  std::vector<double> lengths;   ///< diagonal of the largest element
};

/// From where a point of a set looks for its foot.
template <int D> struct Lookout {
  const FaceSet<D>* set = nullptr;                           ///< null: every foot counts
  Sight<D> sight = {};                                       ///< its body and its current outward normal
  Vec<D> place = Vec<D>::Zero();                             ///< in the reference configuration
  Vec<D> outward = Vec<D>::Zero();                           ///< normal there
  double farthest = std::numeric_limits<double>::infinity(); ///< feet at larger distances do not matter
};

/// True if a local minimum of the distance counts as foot; `normal`: n̄ there; `kept`: it is reached from the foot of a
/// closed point, which may turn towards its flank if its reference place is far away.
template <int D>
bool admissible(const Lookout<D>& from, const FaceGeometry<D>& foot, const Vec<D>& normal, double gap, bool kept);

} // namespace signorini::contact
