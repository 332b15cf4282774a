#pragma once
// Ctrl-C while Lua runs: the flag of base/interrupt.hpp for solves, and an error for the user's own loops.

#include <lua.hpp>

namespace signorini::repl {

/// Catches Ctrl-C. It raises the flag and, as soon as one of the user's own lines runs, the Lua error "interrupted".
/// The library in lua/ is let finish, so that it can roll back; a second Ctrl-C before the first was seen ends the
/// program, unless survive_interrupts() was called.
void catch_interrupts(lua_State* L);

/// While it lives Ctrl-C ends the library's own code, too: where that has nothing to roll back.
class InterruptsLibrary {
public:
  InterruptsLibrary();
  ~InterruptsLibrary();
  InterruptsLibrary(const InterruptsLibrary&) = delete;
  InterruptsLibrary& operator=(const InterruptsLibrary&) = delete;
};

/// From now on, when a solve or a study has ended because of Ctrl-C and returned what it has, the statement that it
/// stands in is finished before the error is raised: `run = model:run(stages)` keeps the run. For what is typed.
void finish_statements();

/// Forgets a Ctrl-C.
void forget_interrupt(lua_State* L);

} // namespace signorini::repl
