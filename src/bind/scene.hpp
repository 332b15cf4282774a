#pragma once
// Bodies, their places and models as Lua sees them.

#include "bind/arguments.hpp"
#include "bind/rigid.hpp"
#include "model/results.hpp"

namespace signorini::bind {

template <int D> using Body = std::shared_ptr<const solid::Body<D>>;

/// Control points of a body that can be held, driven or brought into contact: a face, an edge, or a corner.
template <int D> struct Place {
  Body<D> body;
  std::string name;                ///< "south", "south-front", "south-west"
  std::optional<nurbs::Side> side; ///< of a face
  std::vector<int> functions;
};

template <int D> using Model = std::shared_ptr<model::Model<D>>;

/// A kept state and the model that it belongs to.
template <int D> struct Snapshot {
  Model<D> model;
  model::Snapshot<D> state;
};

template <int D> struct Type<Body<D>> {
  static constexpr auto name = "body", key = D == 3 ? "body in 3D" : name;
  static constexpr int dimension = D;
};
template <int D> struct Type<Place<D>> {
  static constexpr auto name = "face", key = D == 3 ? "face in 3D" : name;
  static constexpr int dimension = D;
};
template <int D> struct Type<Snapshot<D>> {
  static constexpr auto name = "snapshot", key = D == 3 ? "snapshot in 3D" : name;
  static constexpr int dimension = D;
};
template <int D> struct Type<Model<D>> {
  static constexpr auto name = "model", key = D == 3 ? "model in 3D" : name;
  static constexpr int dimension = D;
};

} // namespace signorini::bind
