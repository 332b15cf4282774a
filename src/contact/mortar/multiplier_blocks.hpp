#pragma once
// Blocks of multipliers that are unknowns: their conditions, and their coupling with the displacements.

#include "contact/mortar/multiplier_law.hpp"
#include "contact/mortar/multiplier_rows.hpp"

namespace signorini::contact {

/// Number of unknowns of a multiplier: pressure, and with friction a vector.
template <int D> constexpr int unknowns_per_multiplier(bool frictional) {
  return frictional ? 1 + D : 1;
}
/// The unknowns of a multiplier from those of all.
template <int D> MultiplierUnknowns<D> unknowns_of(const double* all, int multiplier, bool frictional);

/// Fills the block of a multiplier's own rows and columns.
template <int D>
void fill_conditions(const ConditionRows<D>& conditions, int multiplier, bool frictional, bool tangent, Block& block);

/// Fills the block that couples the nodes of a strip with the multipliers of its slave element: derivatives of the
/// conditions with respect to displacements, and of forces with respect to the multipliers' unknowns (scale s).
template <int D>
void fill_coupling(const Strip& strip, const Surface<D>& slave, const Master<D>& master,
                   const MultiplierFunctions<D>& functions, const std::vector<ConditionRows<D>>& conditions,
                   double scale, bool frictional, Block& block);

} // namespace signorini::contact
