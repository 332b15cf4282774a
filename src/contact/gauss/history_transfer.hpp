#pragma once
// Histories of contact points carried to other points of the same slave face, by place on slave and master.

#include "contact/gauss/formulation.hpp"

#include <span>
#include <vector>

namespace signorini::contact {

/// History of a contact point without reference to the elements of its faces.
template <int D> struct PointMemory {
  Vec<D> place; ///< in the reference configuration
  bool touches, slips;
  Vec<D> stretch; ///< x(ξ_slip) − x̄, which friction t_T = ε_T (x̄ − x(ξ_slip)) remembers; zero without a slip point
  double limit; ///< per reference area
  double slipped, recent, worn;
  Projection<D> projection;
};

/// Memories of the points with the given numbers. Both faces of the contact must be in the state of the history.
template <int D>
std::vector<PointMemory<D>> memories(const Formulation<D>& contact, const History<D>& history,
                                     std::span<const std::size_t> numbers);

/// Writes the histories of the points with the given numbers, interpolated between the nearest memories by least
/// squares that are exact for linear fields. A point whose nearest memory does not touch begins without a history, as
/// does one without a closest point, but for its wear. Slip points follow from the interpolated stretch: tractions are
/// carried, not coordinates on the master. Both faces must be in the state of the history, which must be that of the
/// memories, and the master the same; elements and numbers of points may differ. Bonds and multipliers of mortar
/// contact are left alone.
template <int D>
void recall(const std::vector<PointMemory<D>>& memories, const Formulation<D>& contact,
            std::span<const std::size_t> numbers, History<D>& history);

} // namespace signorini::contact
