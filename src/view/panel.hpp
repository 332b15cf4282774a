#pragma once
// What a picture shows, as plain arrays in model units.

#include "base/window.hpp"
#include "view/frame.hpp"
#include "view/marks.hpp"
#include "view/names.hpp"
#include "view/relief.hpp"

#include <array>
#include <string>
#include <vector>

namespace signorini::view {

inline constexpr Rgb plain_colour = {203, 209, 214}; ///< a body without a field
inline constexpr Rgb mesh_colour = {45, 45, 45};     ///< borders of elements, rims
inline constexpr Rgb net_colour = {200, 60, 20};     ///< control points and the lines between them

/// A border between elements, on the true curved geometry. `spacing`: distance to the next one of its kind; where that
/// is small on paper the line is thin, so that fine meshes do not hide the colours.
struct MeshLine {
  Points points;
  double spacing;
};

/// A triangulated surface.
struct Surface {
  Points points;
  Points normals; ///< outward unit normals, one per point; none in the plane
  Triangles triangles;
  VectorX values;      ///< one per point; empty: plain
  Points vectors = {}; ///< one per point, for arrows; or none
};

/// A vector at a place.
struct PointVector {
  Vec<3> at, vector;
};

/// One body ready to be drawn: a surface with z = 0 and what is drawn with it.
struct Body : Surface {
  std::vector<MeshLine> mesh_lines;
  std::vector<Points> rim;                   ///< polylines round the body
  Points control_points;                     ///< drawn as dots when not empty
  std::vector<std::array<int, 2>> net_lines; ///< control net between control points
  std::vector<Points> undeformed;            ///< polylines round the reference shape
};

inline const Surface& skin_of(const Body& body) {
  return body;
}

/// The rim of a rigid obstacle as a polyline, the obstacle on its left; drawn with hatching on that side.
struct Outline {
  Points line;
  bool endless = false; ///< its first and last segment go on for ever
};

/// The rim of a half space; the normal points out of it.
Outline half_plane(const Vec<2>& point, const Vec<2>& normal);
Outline circle(const Vec<2>& centre, double radius, const std::vector<Window>& windows = {});

/// A curve by fractions 0 … 1 of its way: as many even pieces, and more where windows need them.
Outline outline(const std::function<Vec<3>(double)>& place, int pieces, const std::vector<Window>& windows);

/// One state of a model.
struct Panel {
  std::string title; ///< above this state
  std::vector<Body> bodies;
  std::vector<Outline> obstacles = {};
  std::vector<PointMark> marks = {};
  Names names = {};
  std::vector<PointVector> vectors = {}; ///< beside those of the bodies
};

/// Images in the mirror that takes x (axis 0) or y (axis 1) to its negative; `sign` is what happens to the values.
Body mirrored(const Body& body, int axis, double sign);
Outline mirrored(const Outline& outline, int axis);
/// Takes away what of a body lies beyond the mirror.
void join_at_mirror(Body& body, int axis);
PointVector mirrored(PointVector vector, int axis);

/// In pixels.
std::vector<Vec2> on_paper(const Points& points, const Frame& frame);

} // namespace signorini::view
