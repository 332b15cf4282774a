#pragma once
// Rigid obstacles as Lua sees them.

#include "bind/stack.hpp"
#include "contact/obstacle.hpp"

#include <memory>

namespace signorini::bind {

/// What the user called it: a disc is a cylinder in plane strain and a sphere in an axisymmetric model.
enum class RigidForm { plane, cylinder, sphere, surface };
std::string name_of(RigidForm form);

struct RigidShape {
  RigidForm form;
  contact::Obstacle<2> shape;
};
using Rigid = std::shared_ptr<const RigidShape>;

template <> struct Type<Rigid> { static constexpr auto name = "obstacle"; };

} // namespace signorini::bind
