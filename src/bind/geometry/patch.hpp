#pragma once
// Patches as Lua sees them.

#include "bind/lua/arguments.hpp"
#include "bind/lua/functions.hpp"
#include "nurbs/patch.hpp"
#include "nurbs/refine.hpp"

namespace signorini::bind {

template <> struct Type<nurbs::Patch> { static constexpr auto name = "patch"; };

/// One grading per direction of an argument, empty where it is false.
std::vector<std::optional<nurbs::Grading>> gradings_of(const Arguments& a, const char* key);

/// An argument that is a list of patches of one dimension.
std::vector<nurbs::Patch> patches_of(const Arguments& a, const char* key);

} // namespace signorini::bind
