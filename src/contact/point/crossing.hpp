#pragma once
// Detects points that pass through a master between two equilibria without contact: if a step of a cylinder is longer
// than a slab is thick, the cylinder ends behind the slab with a positive gap, as before the step [theory 5.11].

#include "contact/point/master.hpp"

namespace signorini::contact {

/// True if a slave point that moved from `from` to `to`, while the master moved from `before` to `now`, has passed
/// through the master: its gap is positive, its outward normal points away from the master, and its straight path
/// relative to the master has gaps below `allowed` ≤ 0. If it started with such a gap, it has passed through only if it
/// is on another side of the master now. `seed`: start of the closest-point projection.
template <int D>
bool has_crossed(const Master<D>& before, const Master<D>& now, const Vec<D>& from, const Vec<D>& to,
                 const Vec<D>& outward, const Projection<D>& seed, double allowed, const Lookout<D>& lookout = {});

} // namespace signorini::contact
