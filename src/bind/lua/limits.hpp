#pragma once
// Messages about the limits of memory and time, and where in the script memory was missing.

#include <lua.hpp>

#include <string>

namespace signorini::bind {

/// From now on notes the line at which Lua's memory was exhausted. The chunks below the library's folder do not count.
void note_missing_memory(lua_State* L, const std::string& library);

/// What is wrong where memory is missing: the limit of --memory or the machine's memory, and what helps.
std::string missing_memory();

/// Likewise after the position of the user's line at which Lua's memory was exhausted: the error that Lua raises is a
/// fixed text without a position.
std::string missing_lua_memory();

/// Why the run is interrupted: "interrupted" by Ctrl-C, or the time limit.
std::string interruption();

} // namespace signorini::bind
