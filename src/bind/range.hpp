#pragma once
// The range of a colour bar, as pictures and heat maps are told it.

#include "bind/options.hpp"

#include <array>

namespace signorini::bind {

/// `range`: {low, high}.
std::array<double, 2> read_range(lua_State* L, const Options& o);

} // namespace signorini::bind
