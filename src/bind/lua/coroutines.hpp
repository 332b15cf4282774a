#pragma once
// Which coroutine of Lua runs: interrupts and failed allocations concern it, and Lua does not tell.

#include <lua.hpp>

namespace signorini::bind {

/// Replaces coroutine.resume and coroutine.wrap by functions that note the coroutine, and that pass the hook of an
/// interrupt (os/interrupt.hpp) on: hooks belong to one coroutine.
void follow_coroutines(lua_State* L);

/// The thread of Lua that runs; nullptr before follow_coroutines(). For signal handlers, too.
lua_State* running_thread();

} // namespace signorini::bind
