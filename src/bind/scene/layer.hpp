#pragma once
// The arguments `layer` and `layer_knots` of sg.body: where the contact rows have a higher degree and more knots.

#include "bind/lua/arguments.hpp"
#include "nurbs/discretization.hpp"

namespace signorini::bind {

/// Reads both into a plan that is complete otherwise. Throws ArgumentError for ranges outside a face, and for arguments
/// that the plan's label or faces do not allow.
void read_layer(const Arguments& a, const nurbs::Patch& patch, nurbs::Plan& plan);

} // namespace signorini::bind
