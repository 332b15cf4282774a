#pragma once
// Rigid obstacles in space, as surfaces cut to the box of what they touch.

#include "view/solid.hpp"

#include <optional>
#include <variant>

namespace signorini::view {

struct RigidPlane {
  Vec<3> point, normal;
};
struct RigidBall {
  Vec<3> centre;
  double radius;
};
/// Without ends.
struct RigidCylinder {
  Vec<3> point, axis;
  double radius;
};
/// A surface of any form, tessellated, and its border.
struct RigidSurface {
  Surface surface;
  std::vector<SurfaceLine> rim;
};
using Rigid = std::variant<RigidPlane, RigidBall, RigidCylinder, RigidSurface>;

/// The image in the mirror of axis = 0; nothing when the obstacle is its own image.
std::optional<Rigid> mirrored(const Rigid& rigid, int axis);

/// What a picture of bodies within `box` shows of an obstacle: all of one that is no larger than the box, and of the
/// others what lies within the box and a little air; nothing of one that is far away.
RigidSurface shown(const Rigid& rigid, const Bounds& box, const std::vector<Window>& windows = {});

} // namespace signorini::view
