#pragma once
// Pressure and friction of a step at one point that slips, and wears as it slips [theory 7.7].

#include "contact/law/slide.hpp"

namespace signorini::contact {

/// The answer of a law to a gap and a trial friction, with
///   δp = response.rate δg + of_held δp₀ + of_trial·δt*,   and the δt of `slide` at this δp.
template <int N> struct Rubbing {
  Slide<N> slide;
  GapResponse response; ///< p at the gap with the wear of the step, and ∂p/∂g
  double of_held = 1;
  Vec<N> of_trial = Vec<N>::Zero();
  double worn = 0; ///< depth of the step
};

/// Friction at a point whose pressure without wear in this step is unworn.pressure = p₀ + f(g), f the law of the gap
/// and p₀ a given part (of a multiplier). A point that slips by Δγ wears by k p Δγ (J. F. Archard, J. Appl. Phys. 24,
/// 1953), which opens its gap. With backward Euler p and Δγ satisfy both
///   p = p₀ + f(g + k p Δγ),   |t*| − ε_T Δγ = p μ,
/// with the root between 0 and the pressure without wear.
template <int N>
Rubbing<N> rub(const InterfaceLaw& law, const GapResponse& unworn, double gap, const Vec<N>& trial,
               FixedContactState fixed, double tie, const Interface& at);

} // namespace signorini::contact
