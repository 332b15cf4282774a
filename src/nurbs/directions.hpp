#pragma once
// The same points in other parameters: a direction run backwards, two directions exchanged.

#include "nurbs/patch.hpp"

namespace signorini::nurbs {

/// Throws Error when the patch has no direction d (counted from 0).
void check_direction(const Patch& patch, int d);

/// Runs direction d (counted from 0) backwards, on the same interval: its two faces change their names, and a
/// right-handed map becomes left-handed. Throws Error when there is no such direction.
Patch reverse(const Patch& patch, int d);

/// Exchanges directions i and j (counted from 0): with i ≠ j a right-handed map becomes left-handed. Throws Error when
/// there is no such direction.
Patch swap_directions(const Patch& patch, int i, int j);

} // namespace signorini::nurbs
