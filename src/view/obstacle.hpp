#pragma once
// Rigid obstacles: in the plane a thick line, hatched on its inner side, or shaded if it is small; in space a surface
// cut to the box of the bodies that it touches.

#include "view/panel.hpp"

#include <functional>
#include <utility>

namespace signorini::view {

/// The boundary of a half space with its outward normal.
Outline half_plane(const Vec<2>& point, const Vec<2>& normal);
Outline circle(const Vec<2>& center, double radius, const std::vector<Window>& windows = {});

/// A curve, parametrized by 0 … 1, in `pieces` even pieces, finer within windows.
Outline outline(const std::function<Vec<3>(double)>& place, int pieces, const std::vector<Window>& windows);

/// A point of a surface and its unit normal.
using SurfacePlace = std::pair<Vec<3>, Vec<3>>;

/// A surface of columns × rows pieces of a parameter rectangle, refined in windows; `place` gives point and normal at
/// (u, v), both 0 … 1.
Surface tessellated(const std::array<int, 2>& pieces, const std::vector<Window>& windows,
                    const std::function<SurfacePlace(double, double)>& place);

/// The image in the mirror axis = 0; in space empty if the obstacle is its own image.
Outline mirrored(const Outline& outline, int axis);
std::optional<Rigid> mirrored(const Rigid& rigid, int axis);

/// Draws the part of an outline within the box, in pixels.
void draw_obstacle(Drawing& drawing, const Outline& outline, const Box& box, const Style& style);

/// The points of an obstacle that a picture of the given box should show: all if it is not larger than the box, the
/// nearest point if it is infinite and near, otherwise none.
Points worth_showing(const Outline& outline, const Bounds& box);

/// The part of an obstacle that a picture of bodies within `box` shows: all if it is not larger than the box, otherwise
/// the part within the box and a margin; empty if it is far away.
RigidSurface shown(const Rigid& rigid, const Bounds& box, const std::vector<Window>& windows = {});

} // namespace signorini::view
