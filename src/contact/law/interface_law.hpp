#pragma once
// Law of an interface: the traction between two faces as a function of their gap and of the slip of a step
// [theory 5.3]. The pressure follows from the gap, by a penalty or by adhesion; friction from the pressure and the slip
// (slide.hpp).

#include "contact/law/adhesion.hpp"
#include "contact/law/changes.hpp"
#include "contact/law/pressure_formula.hpp"
#include "contact/law/slip_formula.hpp"
#include "contact/law/state.hpp"

#include <limits>

namespace signorini::contact {

/// The slave's area on which the tractions of a law act.
enum class TractionArea : unsigned char { current, reference };

/// The wear that acts on the pressure of a step: what its own slip adds (backward Euler), or what was there before.
enum class WearUpdate : unsigned char { within, after };

/// Depth k p Δγ by which a point wears as it slips; the face does not move, but touches at a gap that is less by it.
struct Wear {
  std::shared_ptr<const SlipFormula> rate; ///< k, of the variables of a coefficient of friction; 1/pressure
  WearUpdate update = WearUpdate::within;
};

/// How the contact conditions are enforced: by a penalty, or with Lagrange multipliers as unknowns (mortar contact).
enum class Enforcement : unsigned char { penalty, multipliers };

/// Penalty parameters are pressure per length. Those of a scene may be 0, which stands for values from material and
/// mesh. With multipliers as unknowns they weigh gaps and slips that the multipliers do not see.
struct InterfaceLaw {
  double normal;                            ///< ε_N > 0; 0 with adhesion or a formula
  double tangential = 0;                    ///< ε_T, used when friction > 0
  double friction = 0;                      ///< Coulomb's μ ≥ 0; 1 if it is a formula, of an ellipse the larger one
  TractionArea per = TractionArea::current; ///< reference, without friction: the forces derive from an energy
  Enforcement enforcement = Enforcement::penalty;
  bool frictional = false;                              ///< μ may change along the path, also if it is 0
  std::optional<Adhesion> adhesion = {};                ///< in place of the penalty: acts at any gap, without friction
  std::shared_ptr<const PressureFormula> pressure = {}; ///< in place of the penalty
  std::shared_ptr<const SlipFormula> coefficient = {};  ///< in place of μ
  std::optional<Wear> wear = {};
  std::optional<Vec<3>> along = {}; ///< of friction that depends on the direction: e₁ in the reference configuration
  std::optional<Vec<2>> ellipse = {}; ///< in place of μ: μ₁ along e₁, μ₂ across
};

/// Adhesion acts on the reference area.
inline InterfaceLaw adhesive(const Adhesion& law) {
  return {.normal = 0, .per = TractionArea::reference, .adhesion = law};
}

/// True if slip matters: friction or wear acts.
inline bool slides(const InterfaceLaw& law) {
  return law.friction > 0 || law.wear;
}
/// True if it does or may do so later.
inline bool may_rub(const InterfaceLaw& law) {
  return law.frictional || slides(law);
}
/// True if the law depends on the rate of slip, so that steps need a duration.
inline bool of_rate(const InterfaceLaw& law) {
  return (law.coefficient && law.coefficient->of_rate) || (law.wear && law.wear->rate->of_rate);
}
/// The law with the constants that a path has changed.
InterfaceLaw changed(InterfaceLaw law, const Changes& changes);

/// Throws Error if a constant is invalid.
void check(const InterfaceLaw& law);
/// The law with its penalty parameters times a factor.
InterfaceLaw scaled(InterfaceLaw law, double factor);

/// True if an ε_N presses.
inline bool has_penalty(const InterfaceLaw& law) {
  return !law.adhesion && !law.pressure;
}
inline GapResponse respond(const InterfaceLaw& law, double gap, const Interface& at) {
  if (law.pressure) return (*law.pressure)(gap, at.place);
  if (law.adhesion) return {traction(*law.adhesion, gap), stiffness(*law.adhesion, gap)};
  return {-law.normal * gap, -law.normal}; // p = −ε_N g
}
/// Energy of the pressure per area.
inline double energy(const InterfaceLaw& law, double gap, const Vec<3>& place) {
  if (law.pressure) return law.pressure->energy(gap, place);
  return law.adhesion ? potential(*law.adhesion, gap) : 0.5 * law.normal * gap * gap; // ε_N g²/2
}
/// The gap below which the law acts.
inline double reach(const InterfaceLaw& law) {
  return law.pressure ? law.pressure->clearance : law.adhesion ? std::numeric_limits<double>::infinity() : 0;
}
/// State of a point on which the law acts with a pressure, without friction.
inline ContactState state_of(const InterfaceLaw& law, double gap, double pressure) {
  if (law.pressure)
    return pressure > 0 ? ContactState::stick : pressure < 0 ? ContactState::adhesion : ContactState::open;
  if (!law.adhesion) return ContactState::stick;
  return gap < strongest_distance(*law.adhesion) ? ContactState::adhesion : ContactState::open;
}
/// The largest derivative of tractions with respect to gap or slip at a point, by its sign that of p′(g).
double stiffness(const InterfaceLaw& law, double gap, const Vec<3>& place);

/// μ at a pressure and a slip of the step; a formula below 0 counts as 0.
inline Coefficient coefficient(const InterfaceLaw& law, double pressure, double slip, const Interface& at) {
  if (!law.coefficient) return {law.friction, 0, 0};
  const Coefficient found = (*law.coefficient)(pressure, slip, at);
  return found.value < 0 ? Coefficient{0, 0, 0} : found;
}

/// The friction from which a point slips in a step, times its area: Coulomb's limit in the accepted state or, where a
/// path has lowered μ, the friction `held` there, if it exceeds the lower limit.
double limit_before(double limit, double mu_before, double mu, double held);

} // namespace signorini::contact
