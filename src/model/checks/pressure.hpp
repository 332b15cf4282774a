#pragma once
// Check of pressures that are formulas of the gap.

#include "model/system/system.hpp"

namespace signorini::model {

/// Throws Error unless, at contact points all over the slave face and at gaps down to half the thickness of the thinner
/// body, p is finite, vanishes at the clearance, does not fall as the faces approach each other where it presses, and
/// pulls only per reference area.
template <int D> void check_pressures(const System<D>& system);

} // namespace signorini::model
