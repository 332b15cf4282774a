#include "contact/law/slide.hpp"

#include <algorithm>

namespace signorini::contact {

template <int N>
Slide<N> slide(const InterfaceLaw& law, const Vec<N>& trial, double pressure, FixedContactState fixed, double tie) {
  Slide<N> result;
  result.friction = trial;
  const double magnitude = trial.norm(), limit = law.friction * std::max(0.0, pressure);
  // (ε_T + μ ε_N) |tie|: change of |t| − μ p due to an error |tie| of gap and slip, below which the direction of the
  // friction is undefined
  const double error = (law.tangential + law.friction * law.normal) * tie;
  if (fixed == FixedContactState::stick || magnitude <= limit + error || magnitude <= -error || magnitude == 0)
    return result;
  result.state = ContactState::slip;
  result.direction = trial / magnitude;
  result.friction = limit * result.direction;
  result.of_trial = (limit / magnitude) * (Mat<N>::Identity() - result.direction * result.direction.transpose());
  if (pressure > 0) result.of_pressure = law.friction;
  result.slipped = (magnitude - limit) / law.tangential;
  return result;
}

template Slide<1> slide(const InterfaceLaw&, const Vec<1>&, double, FixedContactState, double);
template Slide<2> slide(const InterfaceLaw&, const Vec<2>&, double, FixedContactState, double);
template Slide<3> slide(const InterfaceLaw&, const Vec<3>&, double, FixedContactState, double);

} // namespace signorini::contact
