#pragma once
// What an error says that a script raises.

#include <lua.hpp>

namespace signorini::bind {

/// Pushes an error value as text: a table that has no text of its own as what it holds, nil as an error without
/// message.
void push_error_text(lua_State* L, int index);

} // namespace signorini::bind
