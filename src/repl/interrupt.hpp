#pragma once
// Ctrl-C while Lua runs: the flag of base/interrupt.hpp for solves, and an error for the user's own loops.

#include <lua.hpp>

namespace signorini::repl {

/// Catches Ctrl-C. It raises the flag and, as soon as one of the user's own lines runs, the Lua error "interrupted".
/// The library in lua/ is let finish, so that it can roll back; a second Ctrl-C before the first was seen ends the
/// program.
void catch_interrupts(lua_State* L);

/// Forgets a Ctrl-C.
void forget_interrupt(lua_State* L);

} // namespace signorini::repl
