#pragma once
// Bodies, their places and models as Lua sees them.

#include "bind/options.hpp"
#include "bind/rigid.hpp"
#include "model/model.hpp"

namespace signorini::bind {

using Body = std::shared_ptr<const solid::Body<2>>;

/// Control points of a body that can be held, driven or brought into contact: a face, or a corner.
struct Place {
  Body body;
  std::string name;                ///< "south", "south-west"
  std::optional<nurbs::Side> side; ///< absent for a corner
  std::vector<int> functions;
};

using Model = std::shared_ptr<model::Model<2>>;

/// A kept state and the model that it belongs to.
struct Snapshot {
  Model model;
  model::Snapshot<2> state;
};

template <> struct Type<solid::Material> { static constexpr auto name = "material"; };
template <> struct Type<Body> { static constexpr auto name = "body"; };
template <> struct Type<Place> { static constexpr auto name = "face"; };
template <> struct Type<Snapshot> { static constexpr auto name = "snapshot"; };
template <> struct Type<Model> { static constexpr auto name = "model"; };

/// Index of a model's body, support or contact by name. Throws ArgumentError that lists the names.
int find_body(lua_State* L, const Model& model, const std::string& name);
int find_support(lua_State* L, const Model& model, const std::string& name);
int find_contact(lua_State* L, const Model& model, const std::string& name);

} // namespace signorini::bind
