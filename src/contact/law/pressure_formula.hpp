#pragma once
// Pressures that are formulas of the gap and the place: soft layers, asperities, adhesion [theory 5.3].

#include "contact/law/interface.hpp"
#include "symbolic/archive.hpp"
#include "symbolic/tape.hpp"

#include <memory>
#include <string>
#include <vector>

namespace signorini::contact {

/// Pressure p at a gap g that closes the point, with p′(g) and the energy per area.
struct GapResponse {
  double pressure, rate, potential;
};

/// Copies of a law share it.
struct PressureFormula {
  symbolic::Formula formula; ///< of pressure_variables()
  double clearance;          ///< the gap below which it acts, may be infinite
  symbolic::Tape tape;       ///< p and p′

  GapResponse operator()(double gap, const Interface& at) const;
};

/// "g", "X", "Y", "Z".
std::vector<std::string> pressure_variables();
/// The formula as Lua text.
std::string text_of(const PressureFormula& law);

std::shared_ptr<const PressureFormula> make_pressure_formula(symbolic::Formula formula, double clearance);

} // namespace signorini::contact
