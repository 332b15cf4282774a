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

/// ‖t/μ‖, the pressure at which a friction t is on the ellipse.
double pressure_of(const Vec<2>& friction, const Vec<2>& mu) {
  return friction.cwiseQuotient(mu).norm();
}

/// t·d/p of a friction on the ellipse, which slips along its normal d ∥ (t_i/μ_i²).
double along_slip(const Vec<2>& friction, const Vec<2>& mu) {
  return pressure_of(friction, mu) / friction.cwiseQuotient(mu.cwiseAbs2()).norm();
}

/// Returns a trial to the ellipse Σ (t_i/μ_i)² = p², to its closest point or, from inside, where a tie continues to
/// slip, along the ray:
///   t_i = A_i t*_i,   A_i = μ_i²/(μ_i² + ℓ),   w_i = A_i g_i,   g_i = t_i/μ_i²,
///   ∂t/∂t* = diag(A) − w ⊗ w/(g·w),   ∂t/∂p = w p/(g·w)   [theory 7.6].
void return_to_ellipse(const InterfaceLaw& law, const Vec<2>& trial, double pressure, Slide<2>& result) {
  const Vec<2>& mu = *law.ellipse;
  const Vec<2> squares = mu.cwiseAbs2();
  Vec<2> factors = Vec<2>::Ones();
  if (const double inside = pressure / pressure_of(trial, mu); inside > 1) {
    result.friction = inside * trial;
  } else {
    // Newton's method for 1/‖t/μ‖ = 1/p, monotone from ℓ = 0
    double multiplier = 0;
    for (int iteration = 0; iteration < most_slip_iterations; ++iteration) {
      factors = squares.cwiseQuotient((squares.array() + multiplier).matrix());
      result.friction = factors.cwiseProduct(trial);
      const Vec<2> scaled = result.friction.cwiseQuotient(mu);
      const double norm = scaled.norm(), rate = scaled.cwiseAbs2().dot(factors.cwiseQuotient(squares));
      const double next = multiplier + (norm / pressure - 1) * norm * norm / rate;
      if (!(next > multiplier)) break;
      multiplier = next;
    }
  }
  const Vec<2> normal = result.friction.cwiseQuotient(squares), w = factors.cwiseProduct(normal);
  const double scale = normal.dot(w);
  result.of_trial = -w * w.transpose() / scale;
  result.of_trial.diagonal() += factors;
  result.direction = w.normalized();
  result.of_pressure = pressure * w.norm() / scale;
  result.mu = along_slip(result.friction, mu);
  result.slipped = (trial - result.friction).norm() / law.tangential;
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
  Interface here = at;
  if (law.along && magnitude > 0) here.cosine = trial(0) / magnitude;
  Coefficient onset = coefficient(law, p, 0, here);
  result.mu = onset.value;
  if constexpr (N == 2)
    if (law.ellipse && magnitude > 0) {
      onset.value = magnitude / pressure_of(trial, *law.ellipse);
      result.mu = along_slip(trial, *law.ellipse);
    }
  double limit = onset.value * p;
  if (law.coefficient && onset.value == 0 && (*law.coefficient)(p, 0, here).value < 0)
    result.flaw = FrictionFlaw::negative;
  if (!std::isfinite(onset.value) && std::isfinite(magnitude)) result.flaw = FrictionFlaw::undefined;
  // (ε_T + μ ε_N) |tie|: change of |t| − μ p due to an error |tie| of gap and slip, below which the direction of the
  // friction is undefined
  const double error = (law.tangential + onset.value * law.normal) * tie;
  if (fixed == FixedContactState::stick || magnitude <= limit + error || magnitude <= -error || magnitude == 0)
    return result;
  result.state = ContactState::slip;
  if constexpr (N == 2)
    if (law.ellipse && p > 0) {
      return_to_ellipse(law, trial, p, result);
      return result;
    }
  result.direction = trial / magnitude;
  const Mat<N> along = result.direction * result.direction.transpose();
  if (pressure > 0) result.of_pressure = onset.value;
  result.slipped = (magnitude - limit) / law.tangential;
  double share = 0, turn = 0; // 1 − ε_T/D, (ε_T/D) p μ_c/|t*|
  if (law.coefficient && pressure > 0 && magnitude > limit) {
    result.slipped = find_slip(law, magnitude, p, here);
    const Coefficient mu = coefficient(law, p, result.slipped, here);
    const double stiffness = law.tangential + p * mu.of_slip;
    if (law.tangential + p * onset.of_slip <= 0 || stiffness <= 0) result.flaw = FrictionFlaw::jumps;
    if (!is_finite(mu)) result.flaw = FrictionFlaw::undefined;
    result.mu = mu.value;
    limit = p * mu.value;
    share = 1 - law.tangential / stiffness;
    result.of_pressure = (1 - share) * (mu.value + p * mu.of_pressure);
    turn = (1 - share) * p * mu.of_cosine / magnitude;
  }
  result.friction = limit * result.direction;
  result.of_trial = (limit / magnitude) * (Mat<N>::Identity() - along);
  if (share != 0) result.of_trial += share * along;
  // δc = e₁·(I − n nᵀ) δt*/|t*|
  if (turn != 0)
    result.of_trial += turn * result.direction * (Vec<N>::Unit(0) - here.cosine * result.direction).transpose();
  return result;
}

template Slide<1> slide(const InterfaceLaw&, const Vec<1>&, double, FixedContactState, double, const Interface&);
template Slide<2> slide(const InterfaceLaw&, const Vec<2>&, double, FixedContactState, double, const Interface&);
template Slide<3> slide(const InterfaceLaw&, const Vec<3>&, double, FixedContactState, double, const Interface&);

} // namespace signorini::contact
