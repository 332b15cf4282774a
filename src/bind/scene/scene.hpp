#pragma once
// C++ types of materials, bodies, their places, rigid obstacles and models in Lua.

#include "bind/lua/arguments.hpp"
#include "model/results/results.hpp"

namespace signorini::bind {

/// The user's name of the shape: a disc is a cylinder in plane strain, a sphere or a torus in an axisymmetric model.
enum class RigidForm { plane, cylinder, sphere, surface, torus, level_set };

template <int D> struct RigidShape {
  RigidForm form;
  contact::Obstacle<D> shape;
};
template <int D> using Rigid = std::shared_ptr<const RigidShape<D>>;

template <int D> using Body = std::shared_ptr<const solid::Body<D>>;

/// Control points of a body for supports, drives or contact: a face, an edge, or a corner.
template <int D> struct BoundaryPart {
  Body<D> body;
  const char* kind;                ///< "face", "edge" or "corner"
  std::string name;                ///< "south", "south-front", "south-west"
  std::optional<nurbs::Side> side; ///< of a face
  std::vector<int> functions;
};

template <int D> using Model = std::shared_ptr<model::Model<D>>;

/// A saved state and its model.
template <int D> struct Snapshot {
  Model<D> model;
  model::Snapshot<D> state;
};

template <> struct Type<solid::Material> { static constexpr auto name = "material"; };

/// For types that exist in the plane and in space.
template <int D> struct TypeIn { static constexpr int dimension = D; };
template <int D> struct Type<Body<D>> : TypeIn<D> { static constexpr auto name = "body"; };
template <int D> struct Type<BoundaryPart<D>> : TypeIn<D> { static constexpr auto name = "face"; };
template <int D> struct Type<Rigid<D>> : TypeIn<D> { static constexpr auto name = "obstacle"; };
template <int D> struct Type<Snapshot<D>> : TypeIn<D> { static constexpr auto name = "snapshot"; };
template <int D> struct Type<Model<D>> : TypeIn<D> { static constexpr auto name = "model"; };

} // namespace signorini::bind
