#pragma once
// Pictures of states, read from the arguments of sg.picture.

#include "bind/arguments.hpp"
#include "bind/picture.hpp"

namespace signorini::bind {

/// What the arguments show, colored by a field or, where it is empty, gray: patches, a model's present state or a kept
/// one. `state`: where on the stack an entry of run:states() is, or 0. `size`: for how many pixels it is sampled.
Picture read_state_picture(const Arguments& a, const std::string& field, int state, const std::string& title,
                           const std::array<int, 2>& size);

/// Whether an argument is a string.
bool is_string(const Arguments& a, const char* key);

} // namespace signorini::bind
