#pragma once
// Faces, edges and corners of bodies as Lua sees them.

#include "bind/scene.hpp"

namespace signorini::bind {

/// "west", "east", "south", "north", and of a volume "front", "back".
std::vector<std::string> face_names(int dimensions);

/// Methods of bodies: b:face(name), b:edge(name), b:corner(name).
template <int D> int face(lua_State* L);
template <int D> int edge(lua_State* L);
template <int D> int corner(lua_State* L);

/// "face", "edge" or "corner": how many faces meet there.
template <int D> std::string kind_of(const Place<D>& place);

/// As reject(), for a place that is of the wrong kind: names it.
template <int D>
[[noreturn]] void reject_place(lua_State* L, const Place<D>& place, const std::string& where,
                               const std::string& expected, const std::string& cure) {
  throw ArgumentError(text(function_name(L), ": ", where, " must be ", expected, ", got the ", kind_of(place), " '",
                           place.name, "': ", cure));
}

/// Makes the type.
void open_places(lua_State* L);

} // namespace signorini::bind
