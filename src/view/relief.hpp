#pragma once
// What lies beneath a drawing's marks: surfaces colored by values, and lines on them, in pixels, z towards the eye.
// Drawn by OpenGL: what is nearer to the eye hides what is behind it.

#include "base/eigen.hpp"
#include "view/drawing.hpp"

namespace signorini::view {

using Triangles = Eigen::Matrix<int, 3, Eigen::Dynamic>;
using Points = Eigen::Matrix<double, 3, Eigen::Dynamic>;

/// A surface colored by interpolated values; those outside the range take its end colors.
struct Field {
  Points points;
  Points normals; ///< one per point: it is lit; or none
  Triangles triangles;
  VectorX values; ///< one per point
  std::array<double, 2> range;
  std::vector<Rgb> colors; ///< evenly spread over the range
};

/// Triangles of plain color without light.
struct Ink {
  std::vector<Vec<3>> corners; ///< three per triangle
  std::vector<Rgb> colors;     ///< one per triangle
};

/// Lit translucent triangles behind all else, so that they tint no color that has a meaning; each is laid over those
/// before it.
struct Veil {
  std::vector<Vec<3>> corners, normals;            ///< three per triangle
  std::vector<std::array<std::uint8_t, 4>> colors; ///< with opacity, one per triangle
};

struct Relief {
  Box window; ///< nothing shows outside
  std::vector<Field> fields = {};
  Ink ink = {};
  Veil veil = {};
};

struct Pen {
  Rgb color;
  double width;             ///< pixels
  double lift;              ///< pixels towards the eye, so that the surface does not hide its own line
  bool facing_only = false; ///< draw only where the surface faces the eye
};

/// Adds a line whose points are in pixels, z towards the eye, with normals in the same axes. Across the line the ribbon
/// follows the surface's tangent plane, so that it stays visible on surfaces that slope.
void add_ribbon(Ink& ink, const Points& points, const Points& normals, const Pen& pen);

/// Adds a round dot in the picture's plane.
void add_dot(Ink& ink, const Vec<3>& center, double radius, const Rgb& color);

} // namespace signorini::view
