#pragma once
// Lines and circular arcs, exact.

#include "nurbs/transform.hpp"

namespace signorini::nurbs {

/// Straight line, degree 1. Throws Error if the end points coincide.
Patch line(const Point& from, const Point& to);
/// Circular arc in the plane (2D, or 3D at z = center z) from angle `start` to `stop` (degrees, counter-clockwise if
/// increasing), quadratic, on [0, 1]: one segment per quarter turn or part of it, with equally spaced C⁰ knots between
/// segments. Throws Error for a radius ≤ 0 and for an angle of 0 or more than 360°.
Patch arc(const Point& center, double radius, double start, double stop);
/// Full circle: four quarter arcs, counter-clockwise from angle 0.
Patch circle(const Point& center, double radius);

} // namespace signorini::nurbs
