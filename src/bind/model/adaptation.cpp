// Layers that follow the contact, for lua/signorini/run/adapt.lua.

#include "bind/lua/functions.hpp"
#include "bind/lua/open.hpp"
#include "bind/scene/scene.hpp"
#include "model/adapt/following.hpp"

namespace signorini::bind {

namespace {

/// Calls visit(shared pointer to the model) for the model at stack index 1.
template <class Visit> int with_pointer(lua_State* L, Visit visit) {
  if (auto* model = test_object<Model<3>>(L, 1)) return visit(*model);
  return visit(read_object<Model<2>>(L, 1));
}

/// core.check_following(model): raises an error if its layers cannot follow the contact.
int check_following(lua_State* L) {
  return with_pointer(L, [](const auto& model) {
    model::check_following(*model);
    return 0;
  });
}

/// core.layer_lines(model, measured): a list of { body, face, direction, raised, jump }, as model::LayerLine.
int layer_lines(lua_State* L) {
  return with_pointer(L, [&](const auto& model) {
    auto lines = model::layer_lines(*model);
    model::mark_contact(*model, to<bool>(L, 2), lines);
    const auto& bodies = model->system.scene.bodies;
    push_list(L, lines, [&](const model::LayerLine& line) {
      const auto& body = bodies[line.body];
      push_fields(L, "body", body.name, "face", nurbs::name_of(body.body->space().contact()[line.face]), "direction",
                  static_cast<int>(line.direction) + 1, "raised", line.raised, "jump", line.jump);
    });
    return 1;
  });
}

/// core.follow(model, raised): the model, also for all that refer to it in Lua, gets its layers in other elements:
/// a list of true or false for each of core.layer_lines. Returns false if an element would be inverted.
int follow(lua_State* L) {
  return with_pointer(L, [&](auto& model) {
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
    const bool possible = other != nullptr;
    if (possible) {
      model->linear.forget(); // snapshots may keep the old model
      model = std::move(other);
    }
    push(L, possible);
    return 1;
  });
}

constexpr Function following_core[] = {
    {"check_following", wrap<check_following>}, {"layer_lines", wrap<layer_lines>}, {"follow", wrap<follow>}};

} // namespace

void open_adaptation(lua_State* L) {
  register_functions(L, "core", following_core);
}

} // namespace signorini::bind
