#pragma once
// Rigid obstacles on paper: a strong line, hatched on its inner side, or shaded where it is small.

#include "view/panel.hpp"

namespace signorini::view {

/// Draws what lies inside the frame.
void draw_obstacle(Drawing& drawing, const Outline& outline, const Frame& frame, const Style& style);

/// The part of an obstacle that a picture of the given box should show, as points: all of one that is no larger than
/// the box, the nearest point of a near endless one, otherwise nothing.
Points worth_showing(const Outline& outline, const Box& box);

} // namespace signorini::view
