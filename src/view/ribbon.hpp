#pragma once
// Lines on surfaces in space, as flat ribbons that lie on the surface.

#include "view/relief.hpp"

namespace signorini::view {

struct Pen {
  Rgb colour;
  double width;             ///< pixels
  double lift;              ///< pixels towards the eye, so that the surface does not hide its own line
  bool facing_only = false; ///< draw only where the surface faces the eye
};

/// Adds a line whose points are in pixels, z towards the eye, with normals in the same axes. Across the line the ribbon
/// follows the surface's tangent plane, so that it stays visible on surfaces that slope.
void add_ribbon(Ink& ink, const Points& points, const Points& normals, const Pen& pen);

/// Adds a round dot in the picture's plane.
void add_dot(Ink& ink, const Vec<3>& centre, double radius, const Rgb& colour);

} // namespace signorini::view
