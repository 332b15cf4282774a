#pragma once
// Rigid obstacles: in the plane a strong line, hatched on its inner side, or shaded where it is small; in space a
// surface cut to the box of what it touches.

#include "view/panel.hpp"

#include <functional>

namespace signorini::view {

/// The rim of a half space; the normal points out of it.
Outline half_plane(const Vec<2>& point, const Vec<2>& normal);
Outline circle(const Vec<2>& center, double radius, const std::vector<Window>& windows = {});

/// A curve by fractions 0 … 1 of its way: as many even pieces, and more where windows need them.
Outline outline(const std::function<Vec<3>(double)>& place, int pieces, const std::vector<Window>& windows);

/// The image in the mirror of axis = 0; in space nothing when the obstacle is its own image.
Outline mirrored(const Outline& outline, int axis);
std::optional<Rigid> mirrored(const Rigid& rigid, int axis);

/// Draws what lies inside the box of an outline in pixels.
void draw_obstacle(Drawing& drawing, const Outline& outline, const Box& box, const Style& style);

/// The part of an obstacle that a picture of the given box should show, as points: all of one that is no larger than
/// the box, the nearest point of a near endless one, otherwise nothing.
Points worth_showing(const Outline& outline, const Bounds& box);

/// What a picture of bodies within `box` shows of an obstacle: all of one that is no larger than the box, and of the
/// others what lies within the box and a little air; nothing of one that is far away.
RigidSurface shown(const Rigid& rigid, const Bounds& box, const std::vector<Window>& windows = {});

} // namespace signorini::view
