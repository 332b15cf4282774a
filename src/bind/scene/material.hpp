#pragma once
// Materials in words.

#include "solid/material.hpp"

#include <string>

namespace signorini::bind {

/// "E = 1, nu = 0.3"
std::string constants_in_words(const solid::Material& material);

} // namespace signorini::bind
