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
                 const Vec<D>& outward, const Projection<D>& seed, double allowed);

/// The same of a point of a set, which may touch: `last` is its present foot. It has passed through the part that it
/// faced at `from` if it is behind this part's tangent plane by a quarter of the thickness, with a foot on a part that
/// faces the other way or, open without a foot, after a way as deep in the set. `seed`: its foot in the accepted state.
template <int D>
bool has_passed_through(const Master<D>& before, const Master<D>& now, const Vec<D>& from, const Vec<D>& to,
                        const Projection<D>& seed, const Projection<D>& last, bool touching, double allowed,
                        const Lookout<D>& lookout);

} // namespace signorini::contact
