#pragma once
// Coefficients of friction that are formulas of pressure, slip and place [theory 7.5].

#include "base/eigen.hpp"
#include "symbolic/archive.hpp"
#include "symbolic/tape.hpp"

#include <memory>
#include <string>
#include <vector>

namespace signorini::contact {

/// What a coefficient may depend on besides the pressure and the slip Δγ of the step.
struct Rubbing {
  double duration = 0;           ///< Δt of the step; 0: it has none, and formulas see no slip rate
  double slipped = 0;            ///< γ, slip since the touch, in the accepted state
  double recent = 0;             ///< slip since the point last stuck for a whole step, in the accepted state
  Vec<3> place = Vec<3>::Zero(); ///< X, Y[, Z] of the slave point
};

/// A reference position as the place of a Rubbing.
template <class Position> Vec<3> place_of(const Position& position) {
  Vec<3> place = Vec<3>::Zero();
  place.head(position.size()) = position;
  return place;
}

/// μ, ∂μ/∂p and dμ/dΔγ.
struct Coefficient {
  double value, of_pressure, of_slip;
};

/// Copies of a law share it.
struct FrictionFormula {
  symbolic::Formula formula; ///< of friction_variables()
  symbolic::Tape tape;       ///< μ and its derivatives by p, v, slip and recent
  bool of_rate;              ///< it depends on v

  Coefficient operator()(double pressure, double slip, const Rubbing& at) const;
};

/// "p", "v" (slip rate Δγ/Δt), "slip" (γ + Δγ), "X", "Y", "Z", "recent".
std::vector<std::string> friction_variables();

/// The formula as Lua text.
std::string text_of(const FrictionFormula& law);

std::shared_ptr<const FrictionFormula> make_friction_formula(symbolic::Formula formula);

} // namespace signorini::contact
