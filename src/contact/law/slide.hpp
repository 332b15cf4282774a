#pragma once
// Friction of a step at one point, in every formulation: return mapping of the trial friction to Coulomb's cone
// [theory 5.3].

#include "base/eigen.hpp"
#include "contact/law/interface_law.hpp"
#include "contact/law/state.hpp"

namespace signorini::contact {

/// The friction t of a step, a vector of D components or of the D − 1 in the tangent plane, and its derivatives
///   δt = of_trial δt* + of_pressure direction δp.
/// Of a law with an axis t has the components along e₁ and, in space, e₂ (frame.hpp).
/// A point that sticks has t = t*, whose derivatives are those of the trial; the others are not set.
template <int N> struct Slide {
  ContactState state = ContactState::stick;
  /// t·Δ/(p |Δ|) of a point that slips by Δ, without an ellipse |t|/p; of one that sticks where it would begin to
  double mu = 0;
  FrictionFlaw flaw = FrictionFlaw::none;
  Vec<N> friction;
  Vec<N> direction; ///< t*/|t*|, with an ellipse that of ∂t/∂p
  Mat<N> of_trial;
  double of_pressure = 0, slipped = 0; ///< |∂t/∂p|, Δγ
};

/// Returns the trial t* to |t| ≤ μ p. With n = t*/|t*| the slip Δγ of the step is the smallest root of
///   |t*| − ε_T Δγ = p μ(p, Δγ/Δt, γ + Δγ, X, c) =: T,   D = ε_T + p dμ/dΔγ,   c = n·e₁,
///   t = T n,   δt = n [(1 − ε_T/D) n·δt* + (ε_T/D) ((μ + p μ_p) δp + p μ_c δc)] + (T/|t*|) (I − n nᵀ) δt*
/// [theory 7.5]; with a number μ D = ε_T (thesis 3.76). With an ellipse t is the point of Σ (t_i/μ_i)² ≤ p² closest to
/// t* [theory 7.6]. A point whose state is fixed to stick does so at any trial, and at p < 0, where no limit exists.
/// `tie`: distance from the cone within which a trial slip sticks, if negative slips, see Controls::tie().
template <int N>
Slide<N> slide(const InterfaceLaw& law, const Vec<N>& trial, double pressure, FixedContactState fixed, double tie,
               const Interface& at);

} // namespace signorini::contact
