#include "contact/law/slide.hpp"

#include "contact/constants.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::contact {

namespace {

/// The slip at which the limit has fallen or risen to the trial: Newton's method from Δγ = 0, by bisection where it
/// leaves the bracket [0, |t*|/ε_T] of f(Δγ) = |t*| − ε_T Δγ − p μ, f(0) > 0.
double find_slip(const InterfaceLaw& law, double magnitude, double pressure, const Interface& at) {
  double low = 0, high = magnitude / law.tangential, slip = 0;
  for (int iteration = 0; iteration < most_slip_iterations; ++iteration) {
    const Coefficient mu = coefficient(law, pressure, slip, at);
    const double f = magnitude - law.tangential * slip - pressure * mu.value;
    if (std::abs(f) <= slip_rounding * magnitude) break;
    (f > 0 ? low : high) = slip;
    const double next = slip + f / (law.tangential + pressure * mu.of_slip);
    const double before = slip;
    slip = next > low && next < high ? next : 0.5 * (low + high);
    if (slip == before) break;
  }
  return slip;
}

} // namespace

template <int N>
Slide<N> slide(const InterfaceLaw& law, const Vec<N>& trial, double pressure, FixedContactState fixed, double tie,
               const Interface& at) {
  Slide<N> result;
  result.friction = trial;
  const double p = std::max(0.0, pressure), magnitude = trial.norm();
  if (law.friction == 0) {
    // Without friction, of points that wear: the trial is slip
    result.state = ContactState::slip;
    result.slipped = magnitude / law.tangential;
    result.direction = magnitude > 0 ? Vec<N>(trial / magnitude) : Vec<N>(Vec<N>::Zero());
    result.friction.setZero();
    result.of_trial.setZero();
    return result;
  }
  const Coefficient onset = coefficient(law, p, 0, at);
  double limit = onset.value * p;
  result.mu = onset.value;
  if (law.coefficient && onset.value == 0 && (*law.coefficient)(p, 0, at).value < 0)
    result.flaw = FrictionFlaw::negative;
  // (ε_T + μ ε_N) |tie|: change of |t| − μ p due to an error |tie| of gap and slip, below which the direction of the
  // friction is undefined
  const double error = (law.tangential + onset.value * law.normal) * tie;
  if (fixed == FixedContactState::stick || magnitude <= limit + error || magnitude <= -error || magnitude == 0)
    return result;
  result.state = ContactState::slip;
  result.direction = trial / magnitude;
  const Mat<N> along = result.direction * result.direction.transpose();
  if (pressure > 0) result.of_pressure = onset.value;
  result.slipped = (magnitude - limit) / law.tangential;
  double share = 0; // 1 − ε_T/D
  if (law.coefficient && pressure > 0 && magnitude > limit) {
    result.slipped = find_slip(law, magnitude, p, at);
    const Coefficient mu = coefficient(law, p, result.slipped, at);
    const double stiffness = law.tangential + p * mu.of_slip;
    if (law.tangential + p * onset.of_slip <= 0 || stiffness <= 0) result.flaw = FrictionFlaw::jumps;
    result.mu = mu.value;
    limit = p * mu.value;
    share = 1 - law.tangential / stiffness;
    result.of_pressure = (1 - share) * (mu.value + p * mu.of_pressure);
  }
  result.friction = limit * result.direction;
  result.of_trial = (limit / magnitude) * (Mat<N>::Identity() - along);
  if (share != 0) result.of_trial += share * along;
  return result;
}

template Slide<1> slide(const InterfaceLaw&, const Vec<1>&, double, FixedContactState, double, const Interface&);
template Slide<2> slide(const InterfaceLaw&, const Vec<2>&, double, FixedContactState, double, const Interface&);
template Slide<3> slide(const InterfaceLaw&, const Vec<3>&, double, FixedContactState, double, const Interface&);

} // namespace signorini::contact
