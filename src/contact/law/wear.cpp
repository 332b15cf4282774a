#include "contact/law/wear.hpp"

#include "contact/constants.hpp"

#include <cmath>

namespace signorini::contact {

namespace {

/// W = k p Δγ with its derivatives at a pressure, where Δγ follows from the friction there.
template <int N> struct Depth {
  Slide<N> slide;
  double value = 0, of_pressure = 0; ///< W, dW/dp
  Vec<N> of_trial = Vec<N>::Zero();
};

template <int N>
Depth<N> depth_at(const InterfaceLaw& law, double pressure, const Vec<N>& trial, FixedContactState fixed, double tie,
                  const Interface& at) {
  Depth<N> depth{slide<N>(law, trial, pressure, fixed, tie, at)};
  if (depth.slide.state != ContactState::slip || pressure <= 0) return depth;
  const Coefficient k = (*law.wear->rate)(pressure, depth.slide.slipped, at);
  if (k.value < 0) {
    depth.slide.flaw = FrictionFlaw::grows;
    return depth;
  }
  if (!is_finite(k) && std::isfinite(pressure) && std::isfinite(depth.slide.slipped))
    depth.slide.flaw = FrictionFlaw::undefined_wear;
  const double slipped = depth.slide.slipped;
  depth.value = k.value * pressure * slipped;
  // ε_T Δγ = |t* − t|:  δΔγ = m·(δt* − δt)/ε_T,  m the direction of slip
  const Vec<N> m =
      law.ellipse && slipped > 0 ? Vec<N>((trial - depth.slide.friction).normalized()) : depth.slide.direction;
  const double by_slip = pressure * (k.value + slipped * k.of_slip);
  depth.of_trial = (by_slip / law.tangential) * (m - depth.slide.of_trial.transpose() * m);
  depth.of_pressure = slipped * (k.value + pressure * k.of_pressure) -
                      by_slip * depth.slide.of_pressure * m.dot(depth.slide.direction) / law.tangential;
  return depth;
}

} // namespace

template <int N>
Rubbing<N> rub(const InterfaceLaw& law, const GapResponse& unworn, double gap, const Vec<N>& trial,
               FixedContactState fixed, double tie, const Interface& at) {
  if (!law.wear) return {slide<N>(law, trial, unworn.pressure, fixed, tie, at), unworn};
  Depth<N> depth = depth_at(law, unworn.pressure, trial, fixed, tie, at);
  if (law.wear->update == WearUpdate::after || depth.value == 0)
    return {depth.slide, unworn, 1, Vec<N>::Zero(), depth.value};
  // r(p) = p − p₀ − f(g + W) rises from −(p₀ + f(g)) at p = 0: Newton's method, by bisection where it leaves the
  // bracket.
  const double held = unworn.pressure - respond(law, gap, at).pressure;
  double low = 0, high = unworn.pressure, pressure = high;
  GapResponse response = unworn;
  double slope = 1;
  for (int iteration = 0; iteration < most_slip_iterations; ++iteration) {
    response = respond(law, gap + depth.value, at);
    slope = 1 - response.rate * depth.of_pressure;
    const double residual = pressure - held - response.pressure;
    if (std::abs(residual) <= slip_rounding * unworn.pressure) break;
    (residual > 0 ? high : low) = pressure;
    const double next = pressure - residual / slope, before = pressure;
    pressure = next > low && next < high ? next : 0.5 * (low + high);
    if (pressure == before) break;
    depth = depth_at(law, pressure, trial, fixed, tie, at);
  }
  // δp − δp₀ = f′ (δg + W_p δp + W_t·δt*)
  const double rate = response.rate / slope;
  response.pressure = pressure;
  response.rate = rate;
  return {depth.slide, response, 1 / slope, rate * depth.of_trial, depth.value};
}

template Rubbing<1> rub(const InterfaceLaw&, const GapResponse&, double, const Vec<1>&, FixedContactState, double,
                        const Interface&);
template Rubbing<2> rub(const InterfaceLaw&, const GapResponse&, double, const Vec<2>&, FixedContactState, double,
                        const Interface&);
template Rubbing<3> rub(const InterfaceLaw&, const GapResponse&, double, const Vec<3>&, FixedContactState, double,
                        const Interface&);

} // namespace signorini::contact
