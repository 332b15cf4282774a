#include "bind/error_text.hpp"

namespace signorini::bind {

namespace {

/// Pushes what the prompt shows of a table; nothing when that fails. Returns whether it did.
bool push_shown(lua_State* L, int index) {
  lua_getglobal(L, "require");
  lua_pushliteral(L, "signorini.show");
  if (lua_pcall(L, 1, 1, 0) == LUA_OK) {
    lua_getfield(L, -1, "text");
    lua_remove(L, -2);
    lua_pushvalue(L, index);
    if (lua_pcall(L, 1, 1, 0) == LUA_OK) return true;
  }
  lua_pop(L, 1);
  return false;
}

} // namespace

void push_error_text(lua_State* L, int index) {
  index = lua_absindex(L, index);
  const int type = lua_type(L, index);
  if (type == LUA_TNIL) {
    lua_pushliteral(L, "error without a message");
    return;
  }
  const bool bare = type == LUA_TTABLE && luaL_getmetafield(L, index, "__tostring") == LUA_TNIL;
  if (bare && push_shown(L, index)) {
    lua_pushfstring(L, "error: %s", lua_tostring(L, -1));
    lua_remove(L, -2);
    return;
  }
  if (type == LUA_TTABLE && !bare) lua_pop(L, 1);
  luaL_tolstring(L, index, nullptr);
}

} // namespace signorini::bind
