#pragma once
// Surfaces colored by values and lines on them, beneath the marks of a drawing: in pixels, z towards the eye, drawn by
// OpenGL with hidden surfaces removed.

#include "base/eigen.hpp"
#include "view/drawing.hpp"

namespace signorini::view {

using Triangles = Eigen::Matrix<int, 3, Eigen::Dynamic>;
using Points = Eigen::Matrix<double, 3, Eigen::Dynamic>;

/// A surface colored by interpolated values; values outside the range take the end colors.
struct Field {
  Points points;
  Points normals; ///< one per point: lit; empty: unlit
  Triangles triangles;
  VectorX values; ///< one per point
  std::array<double, 2> range;
  std::vector<Rgb> colors; ///< evenly spaced over the range
  Rgb missing;             ///< where the value is nan
};

/// Unlit triangles, each of one color.
struct Ink {
  std::vector<Vec<3>> corners; ///< three per triangle
  std::vector<Rgb> colors;     ///< one per triangle
};

/// Lit translucent triangles behind everything else, so that they do not tint field colors; each is blended over those
/// before it.
struct Translucent {
  std::vector<Vec<3>> corners, normals;            ///< three per triangle
  std::vector<std::array<std::uint8_t, 4>> colors; ///< with opacity, one per triangle
};

struct Relief {
  Box window; ///< clip region
  std::vector<Field> fields = {};
  Ink ink = {};
  Translucent translucent = {};
};

struct Pen {
  Rgb color;
  double width;             ///< pixels
  double lift;              ///< pixels towards the eye, so that the surface does not hide its lines
  bool facing_only = false; ///< draw only where the surface faces the eye
};

/// Adds a line with points in pixels, z towards the eye, and normals in the same axes. The ribbon lies in the tangent
/// plane of the surface, so that it stays visible on inclined surfaces.
void add_ribbon(Ink& ink, const Points& points, const Points& normals, const Pen& pen);

/// Adds a round dot in the picture's plane.
void add_dot(Ink& ink, const Vec<3>& center, double radius, const Rgb& color);

} // namespace signorini::view
