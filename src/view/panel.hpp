#pragma once
// The content of a picture as plain arrays in model units: bodies, obstacles, marks and names of a state.

#include "base/window.hpp"
#include "view/marks.hpp"
#include "view/relief.hpp"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace signorini::view {

inline constexpr Rgb plain_color = {203, 209, 214}; ///< of bodies without a field
inline constexpr Rgb mesh_color = {96, 96, 96};     ///< borders of elements, visible on dark and on light colors
inline constexpr Rgb border_color = {45, 45, 45};   ///< borders of faces
inline constexpr Rgb net_color = {200, 60, 20};     ///< control points and the lines between them

// ── Bodies ───────────────────────────────────────────────────────────────────────────────────────────────────────────

/// A triangulated surface.
struct Surface {
  Points points;
  Points normals; ///< outward unit normals, one per point; empty in the plane
  Triangles triangles;
  VectorX values;      ///< one per point, nan where the field does not exist; empty: no field
  Points vectors = {}; ///< one per point, for arrows; or empty
};

/// A line on a surface, on the exact curved geometry. `spacing`: distance to the next line of its kind, for thinner
/// lines where it is small on paper, so that fine meshes do not cover the colors; 0: full width.
struct SurfaceLine {
  Points points;
  Points normals = {}; ///< of the surface, one per point; empty in the plane
  double spacing = 0;
};

/// Samples of an element at (divisions + 1)³ points, evenly spaced in its parameters, ξ¹ running fastest.
struct Lattice {
  int divisions;
  Points points;
  VectorX values; ///< as those of a surface
};

/// One body, tessellated, in space or in the plane z = 0.
struct Body {
  Surface skin;
  std::vector<SurfaceLine> mesh_lines, rim;
  bool mesh = true;            ///< draw mesh lines, also on cut faces
  bool open = false;           ///< a surface without interior, or a curve: its lines are visible from both sides
  std::vector<Lattice> inside; ///< at least of the elements that a cut plane intersects
  Points control_points;       ///< drawn as dots when not empty
  std::vector<std::array<int, 2>> net_lines; ///< control net between control points
  Surface undeformed;                        ///< drawn translucent when not empty
  std::vector<SurfaceLine> undeformed_rim;   ///< drawn dashed
};

/// A vector at a point.
struct PointVector {
  Vec<3> at, vector;
};

/// Lower and upper corner.
struct Bounds {
  Vec<3> low = Vec<3>::Constant(std::numeric_limits<double>::infinity()), high = -low;

  void take(const Points& points);
  void take(const Bounds& other) { low = low.cwiseMin(other.low), high = high.cwiseMax(other.high); }
  bool empty() const { return (low.array() > high.array()).any(); }
  Vec<3> center() const { return 0.5 * (low + high); }
  double size() const { return (high - low).maxCoeff(); } ///< the longest side

  bool operator==(const Bounds&) const = default;
};

/// Bounds of all bodies as drawn.
Bounds bounds(const Body& body);
Bounds bounds(const std::vector<Body>& bodies);

/// Images in the mirror of the plane x = 0, y = 0 or z = 0 (axis 0, 1, 2); values are multiplied by `sign`.
Surface mirrored(const Surface& surface, int axis, double sign);
Body mirrored(const Body& body, int axis, double sign);
PointVector mirrored(PointVector vector, int axis);

/// Removes the part of a body beyond the mirror. Joins a solid and its image: removes also the surface in the mirror
/// plane, and turns the rims there into element borders.
void join_at_mirror(Body& body, int axis);

// ── Rigid obstacles ──────────────────────────────────────────────────────────────────────────────────────────────────

/// The outline of an obstacle of the plane as a polyline, the obstacle on its left, where it is hatched.
struct Outline {
  Points line;
  bool endless = false; ///< first and last segment are infinite
  Points spoke = {};    ///< of a disc, a line that shows how far it has turned
};

struct RigidPlane {
  Vec<3> point, normal;
};
struct RigidBall {
  Vec<3> center;
  double radius;
};
/// Infinite in both directions.
struct RigidCylinder {
  Vec<3> point, axis;
  double radius;
};
/// A tessellated surface of any form and its border.
struct RigidSurface {
  Surface surface;
  std::vector<SurfaceLine> rim;
};
using Rigid = std::variant<RigidPlane, RigidBall, RigidCylinder, RigidSurface>;

// ── States ───────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Removes the side that the normal points to.
struct CutPlane {
  Vec<3> point, normal; ///< nonzero, of any length
};

/// One state of a model.
struct Panel {
  std::string title; ///< above this state
  std::vector<Body> bodies;
  std::vector<Rigid> obstacles = {};  ///< in space
  std::optional<CutPlane> cut = {};   ///< of bodies and obstacles in space
  std::vector<Outline> outlines = {}; ///< obstacles in the plane
  std::vector<PointMark> marks = {};  ///< drawn on top of everything in front of them
  Names names = {};
  std::vector<PointVector> vectors = {}; ///< in addition to those of the bodies
  std::vector<Window> windows = {};      ///< for obstacles that are tessellated here, all except RigidSurface
};

} // namespace signorini::view
