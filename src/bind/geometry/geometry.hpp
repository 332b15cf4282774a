#pragma once
// Lists of patches with interfaces and boundaries in Lua: { patch1, …, interfaces = { { "1.east", "2.west" }, … },
// boundaries = { outer = { "2.north", … } } }.

#include "bind/lua/stack.hpp"
#include "exchange/exchange.hpp"

namespace signorini::bind {

void push_geometry(lua_State* L, const exchange::Geometry& geometry);

/// The list at a stack index. Throws Error for faces that the patches do not have.
exchange::Geometry read_geometry(lua_State* L, int index);

} // namespace signorini::bind
