#pragma once
// Checkpoints as Lua sees them.

#include "bind/scene.hpp"

namespace signorini::bind {

/// The method m:save(path).
template <int D> int save(lua_State* L);

} // namespace signorini::bind
