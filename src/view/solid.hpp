#pragma once
// Solids ready to be drawn: surfaces and lines in space, and the insides that cut planes lay bare. Plain arrays in
// model units.

#include "view/panel.hpp"

#include <limits>

namespace signorini::view {

/// A line on a surface. `spacing`: distance to the next one of its kind, as for MeshLine; 0 for those of full width.
struct SurfaceLine {
  Points points, normals; ///< one normal of the surface per point
  double spacing = 0;
  VectorX values = {}; ///< of the surface beneath, one per point; or none
};

/// The inside of an element at (divisions + 1)³ points evenly spread over its parameters, ξ¹ running fastest.
struct Lattice {
  int divisions;
  Points points;
  VectorX values; ///< one per point; empty: plain
};

struct Solid {
  Surface skin;
  std::vector<SurfaceLine> mesh_lines, rim;
  bool mesh = true;            ///< draw mesh lines, those of cut faces as well
  bool open = false;           ///< a surface without an inside, or a curve: its lines show from both sides
  std::vector<Lattice> inside; ///< of the elements that a cut plane crosses at least
  Points control_points;       ///< drawn as dots when not empty
  std::vector<std::array<int, 2>> net_lines;
  Surface undeformed; ///< drawn translucent when not empty
  std::vector<SurfaceLine> undeformed_rim;
};

inline const Surface& skin_of(const Solid& solid) {
  return solid.skin;
}

/// lowest and highest corner
struct Bounds {
  Vec<3> low = Vec<3>::Constant(std::numeric_limits<double>::infinity()), high = -low;

  void take(const Points& points);
  bool empty() const { return (low.array() > high.array()).any(); }
  Vec<3> centre() const { return 0.5 * (low + high); }
  double size() const { return (high - low).maxCoeff(); } ///< the longest side

  bool operator==(const Bounds&) const = default;
};

/// Of all that is drawn of a body.
Bounds bounds(const Solid& solid);

/// Images in the mirror of the plane x = 0, y = 0 or z = 0 (axis 0, 1, 2); `sign` is what happens to the values.
Surface mirrored(const Surface& surface, int axis, double sign);
Solid mirrored(const Solid& solid, int axis, double sign);

/// Makes a body and its image one: takes away what lies beyond the mirror, the surface that lies in the plane of the
/// mirror, and turns the rims there into element borders.
void join_at_mirror(Solid& solid, int axis);

} // namespace signorini::view
