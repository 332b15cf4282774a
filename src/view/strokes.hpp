#pragma once
// Lines clipped to a box.

#include "view/drawing.hpp"

#include <array>
#include <vector>

namespace signorini::view {

/// xmin, xmax, ymin, ymax
using Box = std::array<double, 4>;

/// The parts of a polyline inside the box.
std::vector<std::vector<Vec2>> clip_line(const std::vector<Vec2>& line, const Box& box);

} // namespace signorini::view
