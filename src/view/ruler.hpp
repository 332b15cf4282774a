#pragma once
// A length in pictures without numbers along axes: solids in parallel projection.

#include "view/frame.hpp"

namespace signorini::view {

/// Pixels that a ruler takes of the height.
double ruler_room(const Style& style);

/// Draws a line of a round length, about a fifth of the frame's width, with its length and unit at its end. `at`: its
/// start at the bottom left.
void draw_ruler(Drawing& drawing, const Vec2& at, const Scale& scale, const std::string& unit, const Style& style);

} // namespace signorini::view
