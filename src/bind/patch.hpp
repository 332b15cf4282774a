#pragma once
// Patches as Lua sees them, and the pieces of their language that other bindings share.

#include "bind/functions.hpp"
#include "bind/options.hpp"
#include "nurbs/patch.hpp"
#include "nurbs/refine.hpp"

namespace signorini::bind {

template <> struct Type<nurbs::Patch> { static constexpr auto name = "patch"; };

/// Parametric coordinates: a number for a curve, a list else.
VectorX read_parameters(lua_State* L, int index, const nurbs::Patch& patch);

/// One grading per direction from { elements = 0.8, length = 0.1, at = "start" | "end" } or false, in a list; a curve
/// takes the table itself.
std::vector<std::optional<nurbs::Grading>> read_gradings(lua_State* L, int index, const Argument& argument,
                                                         int directions);

/// One whole number per direction: a list, or a single number where there is one direction.
std::vector<int> read_per_direction(lua_State* L, int index, const Argument& argument, int directions, int low,
                                    int high);

/// A parametric direction, counted from 1 in Lua and from 0 here; `name` is the argument's.
int read_direction(lua_State* L, int index, const nurbs::Patch& patch, const char* name = "dir");

/// The methods that give the same shape at another place, of another size, or in other parameters.
std::span<const Function> patch_map_rows();

/// The argument `patch`: a patch or a list of patches, all of one dimension.
std::vector<nurbs::Patch> read_patches(lua_State* L, const Options& o);

/// patch:write(file, form).
int write_patch(lua_State* L);

} // namespace signorini::bind
