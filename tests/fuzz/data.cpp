#include "bind/lua/functions.hpp"
#include "bind/lua/open.hpp"
#include "targets.hpp"

namespace signorini::fuzz {

namespace {

/// A state of Lua with the functions core.read_json, core.write_json, core.pack and core.unpack.
lua_State* state() {
  static lua_State* const L = [] {
    lua_State* made = luaL_newstate();
    luaL_openlibs(made);
    bind::open_json(made);
    return made;
  }();
  lua_settop(L, 0);
  return L;
}

/// Calls core.<name> with the value on top of the stack; returns whether it succeeded.
bool call(lua_State* L, const char* name) {
  bind::push_table(L, "core");
  lua_getfield(L, -1, name);
  lua_remove(L, -2);
  lua_insert(L, -2);
  return lua_pcall(L, 1, 1, 0) == LUA_OK;
}

/// What was read is written and read again.
void repeat(std::string_view input, const char* read, const char* write) {
  lua_State* L = state();
  lua_pushlstring(L, input.data(), input.size());
  if (!call(L, read) || !call(L, write)) return;
  const std::string first = lua_tostring(L, -1) ? std::string(lua_tostring(L, -1), lua_rawlen(L, -1)) : "";
  require_that(call(L, read) && call(L, write), "what was written can be read");
  require_that(std::string(lua_tostring(L, -1), lua_rawlen(L, -1)) == first, "data are read as they were written");
}

} // namespace

void data(std::string_view input) {
  repeat(input, "read_json", "write_json");
  repeat(input, "unpack", "pack");
}

} // namespace signorini::fuzz
