#pragma once
// Patches as Lua sees them, and the pieces of their language that other bindings share.

#include "bind/arguments.hpp"
#include "bind/functions.hpp"
#include "nurbs/patch.hpp"
#include "nurbs/refine.hpp"

namespace signorini::bind {

template <> struct Type<nurbs::Patch> { static constexpr auto name = "patch"; };

/// One grading per direction of an argument, none where it is false.
std::vector<std::optional<nurbs::Grading>> gradings_of(const Arguments& a, const char* key);

/// A parametric direction, counted from 1 in Lua and from 0 here.
inline int direction_at(lua_State* L, int index) {
  return to<int>(L, index) - 1;
}

/// Returns a patch, or what push() takes, to Lua.
template <class T> int returned(lua_State* L, const T& value) {
  if constexpr (std::is_same_v<T, nurbs::Patch>)
    push_object(L, value);
  else
    push(L, value);
  return 1;
}

/// An argument that is a list of patches, all of one dimension.
std::vector<nurbs::Patch> patches_of(const Arguments& a, const char* key);

/// patch:write(file, form).
int write_patch(lua_State* L);

} // namespace signorini::bind
