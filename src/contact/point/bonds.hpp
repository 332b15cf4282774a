#pragma once
// The bonds of a cohesive contact.

#include "contact/law/cohesion.hpp"
#include "contact/point/history.hpp"

namespace signorini::contact {

template <int D> struct Bonds {
  Cohesion law;
  /// Closest points at which the points are bonded in the initial state, with Foot::none if they are not, with an
  /// element if they are only too far from it.
  std::vector<Projection<D>> closest;

  bool bonded(std::size_t i) const { return closest[i].foot != Foot::none; }
  /// State of bond i at its largest opening so far.
  Separation separation(const History<D>& history, std::size_t i) const {
    return separate(law, 0, history.bonds[i].largest);
  }
  /// Fraction of its stiffness that the bond of a point has lost, 1 without a bond.
  double damage(const History<D>& history, std::size_t i) const {
    return bonded(i) ? separation(history, i).damage : 1;
  }
};

} // namespace signorini::contact
