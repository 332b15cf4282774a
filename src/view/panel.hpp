#pragma once
// What a picture shows, as plain arrays in model units: bodies, obstacles, marks and names of a state.

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

inline constexpr Rgb plain_color = {203, 209, 214}; ///< a body without a field
inline constexpr Rgb mesh_color = {45, 45, 45};     ///< borders of elements, rims
inline constexpr Rgb net_color = {200, 60, 20};     ///< control points and the lines between them

// ── Bodies ───────────────────────────────────────────────────────────────────────────────────────────────────────────

/// A triangulated surface.
struct Surface {
  Points points;
  Points normals; ///< outward unit normals, one per point; none in the plane
  Triangles triangles;
  VectorX values;      ///< one per point; empty: plain
  Points vectors = {}; ///< one per point, for arrows; or none
};

/// A line on a surface, on the true curved geometry. `spacing`: distance to the next one of its kind; where that is
/// small on paper the line is thin, so that fine meshes do not hide the colors; 0 for those of full width.
struct SurfaceLine {
  Points points;
  Points normals = {}; ///< one of the surface per point; none in the plane
  double spacing = 0;
  VectorX values = {}; ///< of the surface beneath, one per point; or none
};

/// The inside of an element at (divisions + 1)³ points evenly spread over its parameters, ξ¹ running fastest.
struct Lattice {
  int divisions;
  Points points;
  VectorX values; ///< one per point; empty: plain
};

/// One body ready to be drawn, in space or in the plane z = 0.
struct Body {
  Surface skin;
  std::vector<SurfaceLine> mesh_lines, rim;
  bool mesh = true;            ///< draw mesh lines, those of cut faces as well
  bool open = false;           ///< a surface without an inside, or a curve: its lines show from both sides
  std::vector<Lattice> inside; ///< of the elements that a cut plane crosses at least
  Points control_points;       ///< drawn as dots when not empty
  std::vector<std::array<int, 2>> net_lines; ///< control net between control points
  Surface undeformed;                        ///< drawn translucent when not empty
  std::vector<SurfaceLine> undeformed_rim;   ///< drawn dashed
};

/// A vector at a place.
struct PointVector {
  Vec<3> at, vector;
};

/// lowest and highest corner
struct Bounds {
  Vec<3> low = Vec<3>::Constant(std::numeric_limits<double>::infinity()), high = -low;

  void take(const Points& points);
  void take(const Bounds& other) { low = low.cwiseMin(other.low), high = high.cwiseMax(other.high); }
  bool empty() const { return (low.array() > high.array()).any(); }
  Vec<3> center() const { return 0.5 * (low + high); }
  double size() const { return (high - low).maxCoeff(); } ///< the longest side

  bool operator==(const Bounds&) const = default;
};

/// Of all that is drawn of bodies.
Bounds bounds(const Body& body);
Bounds bounds(const std::vector<Body>& bodies);

/// Images in the mirror of the plane x = 0, y = 0 or z = 0 (axis 0, 1, 2); `sign` is what happens to the values.
Surface mirrored(const Surface& surface, int axis, double sign);
Body mirrored(const Body& body, int axis, double sign);
PointVector mirrored(PointVector vector, int axis);

/// Takes away what of a body lies beyond the mirror. Makes a solid and its image one: takes away the surface that lies
/// in the plane of the mirror, too, and turns the rims there into element borders.
void join_at_mirror(Body& body, int axis);

// ── Rigid obstacles ──────────────────────────────────────────────────────────────────────────────────────────────────

/// The rim of an obstacle of the plane as a polyline, the obstacle on its left; drawn with hatching on that side.
struct Outline {
  Points line;
  bool endless = false; ///< its first and last segment go on for ever
};

struct RigidPlane {
  Vec<3> point, normal;
};
struct RigidBall {
  Vec<3> center;
  double radius;
};
/// Without ends.
struct RigidCylinder {
  Vec<3> point, axis;
  double radius;
};
/// A surface of any form, tessellated, and its border.
struct RigidSurface {
  Surface surface;
  std::vector<SurfaceLine> rim;
};
using Rigid = std::variant<RigidPlane, RigidBall, RigidCylinder, RigidSurface>;

// ── States ───────────────────────────────────────────────────────────────────────────────────────────────────────────

/// What lies on the side that the normal points to is taken away.
struct CutPlane {
  Vec<3> point, normal; ///< of any length but zero
};

/// One state of a model.
struct Panel {
  std::string title; ///< above this state
  std::vector<Body> bodies;
  std::vector<Rigid> obstacles = {};  ///< in space
  std::optional<CutPlane> cut = {};   ///< of bodies and obstacles in space
  std::vector<Outline> outlines = {}; ///< obstacles in the plane
  std::vector<PointMark> marks = {};  ///< drawn on top of all that is in front of them
  Names names = {};
  std::vector<PointVector> vectors = {}; ///< beside those of the bodies
  std::vector<Window> windows = {};      ///< for what is tessellated here: obstacles that are no RigidSurface
};

} // namespace signorini::view
