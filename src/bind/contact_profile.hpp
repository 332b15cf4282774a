#pragma once
// A contact profile as Lua sees it: a table of lists in which a name that is not there is an error, not nil.

#include <lua.hpp>

namespace signorini::bind {

/// Makes the table of lists on top of the stack a contact profile.
void seal_profile(lua_State* L);
/// Whether model:profile made the value.
bool is_profile(lua_State* L, int index);

} // namespace signorini::bind
