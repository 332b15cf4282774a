#pragma once
// Data points as small signs.

#include "view/drawing.hpp"

namespace signorini::view {

/// A sign of about the given radius with a thin white rim; shapes 0 … 7 differ, larger numbers start again.
void draw_marker(Drawing& drawing, int shape, const Vec2& at, double radius, const Rgb& colour);

} // namespace signorini::view
