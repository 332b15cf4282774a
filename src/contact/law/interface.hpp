#pragma once
// What the law of an interface may depend on besides gap, pressure and slip of a step.

#include "base/eigen.hpp"

namespace signorini::contact {

struct Interface {
  double duration = 0;           ///< Δt of the step; 0: it has none, and formulas see no slip rate
  double slipped = 0;            ///< γ, slip since the touch, in the accepted state
  double recent = 0;             ///< slip since the point last stuck for a whole step, in the accepted state
  Vec<3> place = Vec<3>::Zero(); ///< X, Y[, Z] of the slave point
  double cosine = 0;             ///< c of the slave's slip and the axis e₁, set by slide()
};

/// A reference position as the place of an interface.
template <class Position> Vec<3> place_of(const Position& position) {
  Vec<3> place = Vec<3>::Zero();
  place.head(position.size()) = position;
  return place;
}

} // namespace signorini::contact
