#pragma once
// Reparametrization: reversal of a direction, exchange of two directions.

#include "nurbs/patch.hpp"

namespace signorini::nurbs {

/// Throws Error if the patch has no direction d (from 0).
void check_direction(const Patch& patch, int d);

/// Reverses direction d (from 0) on the same interval: its two faces exchange names, and a right-handed map becomes
/// left-handed. Throws Error if the direction does not exist.
Patch reverse(const Patch& patch, int d);

/// Exchanges directions i and j (from 0); if i ≠ j, a right-handed map becomes left-handed. Throws Error if a direction
/// does not exist.
Patch swap_directions(const Patch& patch, int i, int j);

} // namespace signorini::nurbs
