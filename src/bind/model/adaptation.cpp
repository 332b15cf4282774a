// Models that others replace: with layers that follow the contact, for lua/signorini/run/adapt.lua, and on finer
// meshes, for lua/signorini/errors/ladder.lua.

#include "bind/lua/functions.hpp"
#include "bind/lua/open.hpp"
#include "bind/scene/scene.hpp"
#include "model/adapt/following.hpp"

namespace signorini::bind {

namespace {

/// core.layer_lines(model, measured): a list of { body, face, direction, raised, jump }, as model::LayerLine.
template <int D> int layer_lines(const model::Model<D>& model, bool measured, lua_State* L) {
  auto lines = model::layer_lines(model);
  model::mark_contact(model, measured, lines);
  push_list(L, lines, [&](const model::LayerLine& line) {
    const auto& body = model.system.scene.bodies[line.body];
    push_fields(L, "body", body.name, "face", nurbs::name_of(body.body->space().contact()[line.face]), "direction",
                static_cast<int>(line.direction) + 1, "raised", line.raised, "jump", line.jump);
  });
  return 1;
}

/// core.follow(model, raised): the model, also for all that refer to it in Lua, gets its layers in other elements:
/// a list of true or false for each of core.layer_lines. Returns false if an element would be inverted.
template <int D> bool follow(Model<D>& model, lua_State* L) {
  auto lines = model::layer_lines(*model);
  luaL_checktype(L, 2, LUA_TTABLE);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    require(lua_rawgeti(L, 2, static_cast<lua_Integer>(i) + 1) == LUA_TTABLE, "a list for each line is expected");
    for (std::size_t e = 0; e < lines[i].raised.size(); ++e) {
      lua_rawgeti(L, -1, static_cast<lua_Integer>(e) + 1);
      lines[i].raised[e] = lua_toboolean(L, -1) != 0;
      lua_pop(L, 1);
    }
    lua_pop(L, 1);
  }
  auto other = model::with_layers(*model, model::layers(*model, lines));
  if (!other) return false;
  model->linear.forget(); // snapshots may keep the old model
  model = std::move(other);
  return true;
}

/// core.replace(model, other): the other model takes the place of the first, also for all that refer to that in Lua.
template <int D> void replace(Model<D>& model, const Model<D>& other) {
  model->linear.forget(); // snapshots may keep the old model
  model = other;
}

template <int D>
constexpr Function following_core[] = {
    {"check_following", call<model::check_following<D>>}, // raises an error if its layers cannot follow the contact
    {"layer_lines", call<layer_lines<D>>},
    {"follow", call<follow<D>>},
    {"replace", call<replace<D>>},
};

} // namespace

void open_adaptation(lua_State* L) {
  register_functions<Model<2>, Model<3>>(L, "core", following_core<2>, following_core<3>);
}

} // namespace signorini::bind
