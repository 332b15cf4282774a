#pragma once
// Lines and circular arcs, exact.

#include "nurbs/transform.hpp"

namespace signorini::nurbs {

/// Straight line, degree 1. Throws Error when both ends are the same point.
Patch line(const Point& from, const Point& to);
/// Circular arc in the plane (2D, or 3D at z = center z) from angle `start` to `stop` (degrees, counter-clockwise when
/// rising), quadratic, one segment per started quarter turn with C⁰ knots between them at equal knot spacing on [0, 1].
/// Throws Error for a radius ≤ 0 and for a turn of 0 or of more than 360°.
Patch arc(const Point& center, double radius, double start, double stop);
/// Full circle: four quarter arcs, counter-clockwise from the angle 0.
Patch circle(const Point& center, double radius);

} // namespace signorini::nurbs
