#pragma once
// Coefficients of friction that are formulas of pressure, slip and place [theory 7.5].

#include "contact/law/interface.hpp"
#include "symbolic/archive.hpp"
#include "symbolic/tape.hpp"

#include <memory>
#include <string>
#include <vector>

namespace signorini::contact {

/// μ, ∂μ/∂p, dμ/dΔγ and ∂μ/∂c.
struct Coefficient {
  double value, of_pressure, of_slip, of_cosine = 0;
};

/// Copies of a law share it.
struct FrictionFormula {
  symbolic::Formula formula; ///< of friction_variables()
  symbolic::Tape tape;       ///< μ and its derivatives by p, v, slip, recent and cosine
  bool of_rate, of_cosine;   ///< it depends on v, on the direction of sliding

  Coefficient operator()(double pressure, double slip, const Interface& at) const;
};

/// "p", "v" (slip rate Δγ/Δt), "slip" (γ + Δγ), "X", "Y", "Z", "recent", "cosine".
std::vector<std::string> friction_variables();

/// The formula as Lua text.
std::string text_of(const FrictionFormula& law);

std::shared_ptr<const FrictionFormula> make_friction_formula(symbolic::Formula formula);

} // namespace signorini::contact
