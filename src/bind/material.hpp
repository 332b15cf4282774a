#pragma once
// Materials as Lua sees them.

#include "bind/stack.hpp"
#include "solid/material.hpp"

namespace signorini::bind {

template <> struct Type<solid::Material> { static constexpr auto name = "material"; };

/// "E = 1, nu = 0.3"
std::string constants_in_words(const solid::Material& material);

} // namespace signorini::bind
