#pragma once
// Marks in pictures as Lua gives them.

#include "bind/options.hpp"
#include "view/marks.hpp"

namespace signorini::bind {

/// The list `marks` of a state of this dimension; none when it is missing. Entries may hold all that the places of a
/// failed run hold.
std::vector<view::PointMark> read_marks(lua_State* L, const Options& o, int dimension);

} // namespace signorini::bind
