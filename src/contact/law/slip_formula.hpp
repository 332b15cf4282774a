#pragma once
// Formulas of pressure, slip and place: coefficients of friction and rates of wear [theory 7.5, 7.7].

#include "contact/law/interface.hpp"
#include "symbolic/archive.hpp"
#include "symbolic/tape.hpp"

#include <memory>
#include <string>
#include <vector>

namespace signorini::contact {

/// The value, here μ, and its ∂/∂p, d/dΔγ and ∂/∂c.
struct Coefficient {
  double value, of_pressure, of_slip, of_cosine = 0;
};

bool is_finite(const Coefficient& coefficient);

/// Copies of a law share it.
struct SlipFormula {
  symbolic::Formula formula; ///< of slip_variables()
  symbolic::Tape tape;       ///< the value and its derivatives by p, v, slip, recent and cosine
  bool of_rate, of_cosine;   ///< it depends on v, on the direction of sliding

  Coefficient operator()(double pressure, double slip, const Interface& at) const;
};

/// "p", "v" (slip rate Δγ/Δt), "slip" (γ + Δγ), "X", "Y", "Z", "recent", "cosine".
std::vector<std::string> slip_variables();

/// The formula as Lua text.
std::string text_of(const SlipFormula& law);

std::shared_ptr<const SlipFormula> make_slip_formula(symbolic::Formula formula);

} // namespace signorini::contact
