#pragma once
// Points that pass through a master from one equilibrium to the next, where no contact is seen: a step of a cylinder
// that is longer than a slab is thick ends behind it, with a gap as before it.

#include "contact/master.hpp"

namespace signorini::contact {

/// Whether a slave point that has moved from `from` to `to`, while the master has moved from `before` to `now`, has
/// gone through the master: it is off the master, on the side that its own outward normal points away from, and the
/// straight way to it, as seen from the master, leads through. `seed`: where to look for the closest point first.
template <int D>
bool has_crossed(const Master<D>& before, const Master<D>& now, const Vec<D>& from, const Vec<D>& to,
                 const Vec<D>& outward, const Projection<D>& seed);

} // namespace signorini::contact
