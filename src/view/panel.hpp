#pragma once
// What a picture shows, as plain arrays in model units.

#include "base/window.hpp"
#include "view/frame.hpp"
#include "view/marks.hpp"
#include "view/names.hpp"

#include <array>
#include <string>
#include <vector>

namespace signorini::view {

using Triangles = Eigen::Matrix<int, 3, Eigen::Dynamic>;
using Points = Eigen::Matrix<double, 3, Eigen::Dynamic>;

/// A border between elements, on the true curved geometry. `spacing`: distance to the next one of its kind; where that
/// is small on paper the line is thin, so that fine meshes do not hide the colours.
struct MeshLine {
  Points points;
  double spacing;
};

/// One body ready to be drawn. Plane bodies have z = 0.
struct Body {
  Points points;       ///< tessellation points
  Triangles triangles; ///< indices into points
  VectorX values;      ///< one per point; empty: drawn in plain grey
  std::vector<MeshLine> mesh_lines;
  std::vector<Points> rim;                   ///< polylines round the body
  Points control_points;                     ///< drawn as dots when not empty
  std::vector<std::array<int, 2>> net_lines; ///< control net between control points
  std::vector<Points> undeformed;            ///< polylines round the reference shape
};

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
};

/// Images in the mirror that takes x (axis 0) or y (axis 1) to its negative; `sign` is what happens to the values.
Body mirrored(const Body& body, int axis, double sign);
Outline mirrored(const Outline& outline, int axis);

/// In pixels.
std::vector<Vec2> on_paper(const Points& points, const Frame& frame);

} // namespace signorini::view
