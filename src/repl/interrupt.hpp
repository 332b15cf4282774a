#pragma once
// Ctrl-C and the end of --time while Lua runs: the flag of os/interrupt.hpp for solves, and an error for loops in
// user code.

#include <lua.hpp>

#include <string>

namespace signorini::repl {

/// Handles Ctrl-C: sets the flag and, when a line of user code runs next, raises the Lua error "interrupted". The
/// library in lua/ is not interrupted, so that it can roll back; a second Ctrl-C before the first was handled ends the
/// program, unless survive_interrupts() was called.
void catch_interrupts();

/// Ends Lua in the same way when the time is over that start_time_limit() has started (os/limits.hpp). `written`: in
/// the user's notation.
void limit_time(double seconds, const std::string& written);

/// During its lifetime Ctrl-C also interrupts library code: for parts without anything to roll back.
class InterruptsLibrary {
public:
  InterruptsLibrary();
  ~InterruptsLibrary();
  InterruptsLibrary(const InterruptsLibrary&) = delete;
  InterruptsLibrary& operator=(const InterruptsLibrary&) = delete;
};

/// From now on, after a solve or study has ended by Ctrl-C and returned partial results, the statement that contains it
/// is completed before the error is raised: `run = model:run(stages)` keeps the run. For interactive input.
void finish_statements();

/// Clears the flag, and stops the time.
void forget_interrupt(lua_State* L);

} // namespace signorini::repl
