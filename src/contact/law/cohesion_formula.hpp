#pragma once
// Tractions of bonds that are formulas of the opening and of the mode mix [theory 9.3].

#include "symbolic/archive.hpp"
#include "symbolic/tape.hpp"

#include <memory>
#include <string>
#include <vector>

namespace signorini::contact {

/// Traction T(u, m) of a bond that opens for the first time, with
///   u² = Δ_n² + b² |Δ_t|²,   m = b² |Δ_t|²/u²,
/// m the share of shear in the work at a fixed ratio of the two. Copies of a law share it.
struct CohesionFormula {
  symbolic::Formula formula; ///< of cohesion_variables()
  double shear;              ///< b
  symbolic::Tape tape;       ///< T, T_u, T_m
  bool mixed;                ///< depends on m
  double stiffness;          ///< K = T_u(0), for every m
  double length;             ///< the opening at which the stiffness has fallen to K/2, at m = 0

  /// The fraction w = T/(K u) of its stiffness that opening leaves, with its derivatives.
  struct Left {
    double value, of_opening, of_mix;
  };
  Left left(double opening, double mix) const;
  /// What a loss of stiffness, from one fraction to another, dissipates per area at a mixture, and the part that is
  /// left of the energy of separation.
  struct Loss {
    double dissipated, remaining;
  };
  /// `near`: guesses of the openings at which first opening leaves as much.
  Loss loss(double before, double after, double mix, double near_first = 0, double near_last = 0) const;

  double traction(double opening, double mix) const;
  /// ∫_u^∞ T du + ½ T u: the energy per area that complete separation still dissipates.
  double rest(double opening, double mix) const;
  /// Largest traction at a mixture and the opening there.
  struct Peak {
    double traction, opening;
  };
  Peak peak(double mix) const;
};

/// "u", "m".
std::vector<std::string> cohesion_variables();
/// The formula as Lua text.
std::string text_of(const CohesionFormula& law);

/// Throws Error unless T is finite and not negative, T(0) = 0, T/u does not rise, T_u(0) > 0 is the same for all m, and
/// the area below T is finite: checked at samples.
std::shared_ptr<const CohesionFormula> make_cohesion_formula(symbolic::Formula formula, double shear);

} // namespace signorini::contact
