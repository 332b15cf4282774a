#include "bind/contact_profile.hpp"

#include "bind/functions.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

constexpr const char* type_name = "contact profile";

std::vector<std::string> names_of_lists(lua_State* L, int index) {
  std::vector<std::string> names;
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1))
    if (lua_type(L, -2) == LUA_TSTRING) names.emplace_back(lua_tostring(L, -2));
  std::sort(names.begin(), names.end());
  return names;
}

/// __index of a profile: called only for what it does not hold.
int missing(lua_State* L) {
  const auto known = names_of_lists(L, 1);
  if (lua_type(L, 2) != LUA_TSTRING)
    throw ArgumentError(text("a contact profile has no entry ", describe(L, 2),
                             ": it has lists with one value per contact point, such as profile.pressure[1]; they are ",
                             listed(known)));
  const std::string name = lua_tostring(L, 2);
  const std::string hint = did_you_mean(name, known);
  throw ArgumentError(
      text("a contact profile has no '", name, "'", hint, hint.empty() ? ": it has " : " It has ", listed(known)));
}

} // namespace

void seal_profile(lua_State* L) {
  if (luaL_newmetatable(L, type_name)) {
    lua_pushcfunction(L, wrap<missing>);
    lua_setfield(L, -2, "__index");
  }
  lua_setmetatable(L, -2);
}

bool is_profile(lua_State* L, int index) {
  if (lua_type(L, index) != LUA_TTABLE || !lua_getmetatable(L, index)) return false;
  const bool same = luaL_getmetatable(L, type_name) == LUA_TTABLE && lua_rawequal(L, -1, -2);
  lua_pop(L, 2);
  return same;
}

} // namespace signorini::bind
