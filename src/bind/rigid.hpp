#pragma once
// Rigid obstacles as Lua sees them.

#include "bind/stack.hpp"
#include "contact/obstacle.hpp"

#include <memory>

namespace signorini::bind {

/// What the user called it: a disc is a cylinder in plane strain and a sphere in an axisymmetric model.
enum class RigidForm { plane, cylinder, sphere, surface };
std::string name_of(RigidForm form);

template <int D> struct RigidShape {
  RigidForm form;
  contact::Obstacle<D> shape;
};
template <int D> using Rigid = std::shared_ptr<const RigidShape<D>>;

template <int D> struct Type<Rigid<D>> {
  static constexpr auto name = "obstacle", key = D == 3 ? "obstacle in 3D" : name;
  static constexpr int dimension = D;
};

} // namespace signorini::bind
