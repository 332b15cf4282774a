#pragma once
// Plane geometry of lines: clipping to a box, cutting into dashes, and widening into triangles.

#include "view/drawing.hpp"

#include <array>
#include <vector>

namespace signorini::view {

/// xmin, xmax, ymin, ymax
using Box = std::array<double, 4>;

/// The parts of a polyline inside the box.
std::vector<std::vector<Vec2>> clip_line(const std::vector<Vec2>& line, const Box& box);

/// The drawn parts of a polyline under a dash pattern; the line itself when the pattern is empty.
std::vector<std::vector<Vec2>> dash_line(const std::vector<Vec2>& line, const std::vector<double>& pattern);

/// Corners of triangles, three each, that cover a stroke with round joins and flat ends.
std::vector<Vec2> stroke_triangles(const Stroke& stroke);

} // namespace signorini::view
