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
    const PointBond<D>& bond = history.bonds[i];
    Separation found = separate(law, 0, bond.largest, bond.mix, bond.left);
    if (law.formula) found.dissipated = bond.dissipated;
    return found;
  }
  /// Fraction of its stiffness that the bond of a point has lost, 1 without a bond.
  double damage(const History<D>& history, std::size_t i) const {
    return bonded(i) ? separation(history, i).damage : 1;
  }
  /// Area of new surface: of each point the energy dissipated over the energy of separation.
  double debonded(const ContactPoints<D>& points, const History<D>& history) const {
    if (!law.formula) return history.debonding / law.energy;
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      sum += reference_area(points.list[i]) * (1 - history.bonds[i].remaining);
    return sum;
  }
};

} // namespace signorini::contact
