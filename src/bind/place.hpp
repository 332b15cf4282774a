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

/// Makes the type.
void open_places(lua_State* L);

} // namespace signorini::bind
