#pragma once
// First touch: the point of the master at which an open slave point closes on the way to the guess of a step. Friction
// acts from there [theory 7.2].

#include "contact/point/master.hpp"

#include <optional>

namespace signorini::contact {

/// A point of a slave face and the gap at which it touches.
template <int D> struct Touching {
  Vec<D> position;
  double offset;
};

/// The foot point where a point closes its gap on the straight way, relative to the master, from the accepted state
/// `from` to `to` at the guess, with the offset linear along it; the foot in the accepted state if the point is closed
/// there. None if the point has no foot or does not close. `before`, `now`: the master in both states; `seed`: start of
/// the closest-point projections.
template <int D>
std::optional<MasterPoint<D>> touch_point(const Master<D>& before, const Master<D>& now, const Touching<D>& from,
                                          const Touching<D>& to, const Projection<D>& seed,
                                          const Lookout<D>& lookout = {});

/// The fraction of a step at which a gap closes that changes linearly from `before` to `now` < 0: 0 if it is closed
/// before.
double touch_fraction(double before, double now);

} // namespace signorini::contact
