#pragma once
// Pressures that are formulas of the gap and the place: soft layers, asperities, adhesion [theory 5.3].

#include "contact/law/interface.hpp"
#include "symbolic/archive.hpp"
#include "symbolic/tape.hpp"

#include <memory>
#include <string>
#include <vector>

namespace signorini::contact {

/// Pressure p at a gap g that closes the point, with p′(g).
struct GapResponse {
  double pressure, rate;
};

/// Copies of a law share it.
struct PressureFormula {
  symbolic::Formula formula; ///< of pressure_variables()
  double clearance;          ///< the gap below which it acts, may be infinite
  symbolic::Tape tape;       ///< p and p′

  GapResponse operator()(double gap, const Vec<3>& place) const;
  /// ∫ p dg from a gap to the clearance, energy per area: 16 to 48 times the work of a pressure.
  double energy(double gap, const Vec<3>& place) const;
};

/// "g", "X", "Y", "Z".
std::vector<std::string> pressure_variables();
/// The formula as Lua text.
std::string text_of(const PressureFormula& law);

std::shared_ptr<const PressureFormula> make_pressure_formula(symbolic::Formula formula, double clearance);

} // namespace signorini::contact
