#pragma once
// Data points as small signs.

#include "view/drawing.hpp"

namespace signorini::view {

/// The sign of this number in marker_names(), of about the given radius, with a thin white rim; larger numbers start
/// again.
void draw_marker(Drawing& drawing, int marker, const Vec2& at, double radius, const Rgb& colour);

} // namespace signorini::view
