#pragma once
// Several faces with common borders as one face: a chain of curves, or a rectangular grid of surfaces.

#include "base/message.hpp"
#include "nurbs/orientation.hpp"
#include "nurbs/patch.hpp"

#include <vector>

namespace signorini::contact {

/// A face of the whole.
struct FacePart {
  nurbs::Row row;
  std::vector<int> nodes; ///< of its control points; points that several faces share have one node
  double orientation;     ///< nurbs::outward_sign()
  Message name;
};

/// Where a part lies: its orientation in the whole, and its elements there.
struct FacePlace {
  nurbs::Orientation way;
  std::array<int, 2> elements; ///< per direction of the part
  std::array<int, 2> first;    ///< per direction of the whole
  int width;                   ///< number of elements of the whole in its first direction

  /// The whole's element that is element f of the part (first direction fastest).
  int element(int f) const;
  /// Index of a point in the whole's element; `number`: in the part's, of a grid with this number per direction.
  int point(int number, int per_direction) const;
};

/// Continuous across the borders of the parts (C⁰), with the directions of the first part.
struct FaceGrid {
  nurbs::Row row;
  std::vector<int> nodes;
  double orientation;
  std::vector<FacePlace> places; ///< of the parts, in their order
};

/// Throws Error if the parts have no common borders, do not lie on one side of the bodies, or are not a full grid.
/// `list`: the list of the parts in messages.
FaceGrid arrange(const std::vector<FacePart>& parts, const Message& list);

} // namespace signorini::contact
