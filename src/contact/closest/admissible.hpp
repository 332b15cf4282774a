#pragma once
// Feet of a point of a set of faces: its distance from the set has the minimum zero, at the point itself, and others
// that do not count, such as the back of a wall [theory 8.4].

#include "contact/face/search.hpp"
#include "contact/face/surroundings.hpp"

#include <limits>
#include <memory>
#include <vector>

namespace signorini::contact {

/// What belongs to the faces of a set, by sheet of its surface.
struct SetParts {
  std::vector<int> bodies;       ///< behind it; joined bodies have one number
  std::vector<double> thickness; ///< of the body behind it
  std::vector<char> apart = {};  ///< by two sheets, true if they do not touch each other; empty: all do

  bool touch(int sheet, int other) const { return apart.empty() || !apart[sheet * bodies.size() + other]; }
};

/// Constant data of a set of faces.
template <int D> struct FaceSet : SetParts {
  Surface<D> reference;        ///< in the reference configuration, with the elements of the moving surface
  std::vector<double> lengths; ///< diagonal of the largest element
  Surroundings surroundings;
};

/// From where a point of a set looks for its foot.
template <int D> struct Lookout {
  const FaceSet<D>* set = nullptr;                           ///< null: every foot counts
  int sheet = 0;                                             ///< of the point
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
