#include "bind/lua/stack.hpp"

#include <algorithm>

namespace signorini::bind {

bool has_type(lua_State* L, int index, const char* name) {
  if (!lua_isuserdata(L, index) || luaL_getmetafield(L, index, "__name") != LUA_TSTRING) return false;
  const bool same = lua_tostring(L, -1) == std::string_view(name);
  lua_pop(L, 1);
  return same;
}

void reject_dimension(const Argument& argument, const char* name, int expected) {
  const char *plane = "in the plane", *space = "in 3D";
  fail(argument.name, " must be ", with_article(name), " ", expected == 2 ? plane : space, ", got one ",
       expected == 2 ? space : plane, ": all parts of a model must be in the plane, or all in 3D");
}

void count_memory(lua_State* L, double bytes) {
  lua_gc(L, LUA_GCSTEP, static_cast<int>(std::min(bytes / 1024, 1e6)));
}

} // namespace signorini::bind
