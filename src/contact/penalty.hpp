#pragma once
// The penalty law at one contact point: traction of normal contact and Coulomb friction with its exact linearization.

#include "contact/local.hpp"

namespace signorini::contact {

/// Penalty parameters are pressure per length.
struct PenaltyLaw {
  double normal;         ///< ε_N > 0
  double tangential = 0; ///< ε_T, used when friction > 0
  double friction = 0;   ///< Coulomb's μ ≥ 0
};

/// Evaluates the law at a touching point: t_N = λ_N − ε_N g > 0, or at one that is held.
template <int D> void penalty_force(const PenaltyLaw& law, const LocalGeometry<D>& geometry, LocalForce<D>& result);

} // namespace signorini::contact
