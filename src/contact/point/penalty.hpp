#pragma once
// Penalty law at one contact point: normal contact and Coulomb friction with the consistent tangent.

#include "contact/point/changes.hpp"
#include "contact/point/local.hpp"

namespace signorini::contact {

/// The slave's area on which the tractions of a law act.
enum class TractionArea : unsigned char { current, reference };

/// How the contact conditions are enforced: by a penalty, or with Lagrange multipliers as unknowns (mortar contact).
enum class Enforcement : unsigned char { penalty, multipliers };

/// Penalty parameters are pressure per length. Those of a scene may be 0, which stands for values from material and
/// mesh. With multipliers as unknowns they weigh gaps and slips that the multipliers do not see.
struct PenaltyLaw {
  double normal;                            ///< ε_N > 0
  double tangential = 0;                    ///< ε_T, used when friction > 0
  double friction = 0;                      ///< Coulomb's μ ≥ 0
  TractionArea per = TractionArea::current; ///< reference, without friction: the forces derive from an energy
  Enforcement enforcement = Enforcement::penalty;
  bool frictional = false; ///< μ may change along the path, also if it is 0
};

/// True if friction acts or may act later.
inline bool may_rub(const PenaltyLaw& law) {
  return law.frictional || law.friction > 0;
}
/// The law with the constants that a path has changed.
PenaltyLaw changed(PenaltyLaw law, const Changes& changes);

/// Throws Error if a constant is invalid.
void check(const PenaltyLaw& law);
/// The law with its penalty parameters times a factor.
PenaltyLaw scaled(PenaltyLaw law, double factor);
/// The larger penalty parameter in use.
double largest_penalty(const PenaltyLaw& law);

/// The friction from which a point slips in a step, times its area: Coulomb's limit in the accepted state or, where a
/// path has lowered μ, the friction `held` there, if it exceeds the lower limit.
double limit_before(double limit, double mu_before, double mu, double held);

/// True if a trial friction exceeds Coulomb's limit by more than `tie`, unless the state is fixed to stick. Below |tie|
/// the direction of the friction is undefined.
inline bool slips(FixedContactState fixed, double trial, double limit, double tie) {
  return fixed != FixedContactState::stick && trial > limit + tie && trial > -tie;
}

/// Evaluates the law (return mapping) [theory 5.3] [theory 7.1] at a closed point, t_N = −ε_N (g − o) > 0 with the
/// offset o, or at one with a fixed state.
template <int D> void penalty_force(const PenaltyLaw& law, const LocalGeometry<D>& geometry, LocalForce<D>& result);

} // namespace signorini::contact
