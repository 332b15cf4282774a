#pragma once
// Bodies, their places and models as Lua sees them.

#include "bind/options.hpp"
#include "bind/rigid.hpp"
#include "model/model.hpp"

namespace signorini::bind {

template <int D> using Body = std::shared_ptr<const solid::Body<D>>;

/// Control points of a body that can be held, driven or brought into contact: a face, or a corner.
template <int D> struct Place {
  Body<D> body;
  std::string name;                ///< "south", "south-west"
  std::optional<nurbs::Side> side; ///< absent for a corner
  std::vector<int> functions;
};

template <int D> using Model = std::shared_ptr<model::Model<D>>;

/// A kept state and the model that it belongs to.
template <int D> struct Snapshot {
  Model<D> model;
  model::Snapshot<D> state;
};

template <> struct Type<solid::Material> { static constexpr auto name = "material"; };
template <int D> struct Type<Body<D>> { static constexpr auto name = "body"; };
template <int D> struct Type<Place<D>> { static constexpr auto name = "face"; };
template <int D> struct Type<Snapshot<D>> { static constexpr auto name = "snapshot"; };
template <int D> struct Type<Model<D>> { static constexpr auto name = "model"; };

/// Index of a model's body, support or contact by name. Throws ArgumentError that lists the names.
template <int D> int find_body(lua_State* L, const Model<D>& model, const std::string& name);
template <int D> int find_support(lua_State* L, const Model<D>& model, const std::string& name);
template <int D> int find_contact(lua_State* L, const Model<D>& model, const std::string& name);

} // namespace signorini::bind
