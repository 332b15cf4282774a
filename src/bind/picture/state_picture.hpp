#pragma once
// Pictures of states, read from the arguments of sg.picture.

#include "bind/lua/arguments.hpp"
#include "bind/picture/picture.hpp"

namespace signorini::bind {

/// The picture of the arguments, colored by a field or, if it is empty, gray: patches, the present or a saved state of
/// a model. `state`: stack index of an entry of run:states(), or 0. `size`: pixels for which it is sampled.
Picture read_state_picture(const Arguments& a, const std::string& field, int state, const std::string& title,
                           const std::array<int, 2>& size);

} // namespace signorini::bind
