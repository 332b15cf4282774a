#pragma once
// Contact conditions at one point of a contact with multipliers that are unknowns: normal contact and Coulomb friction
// as equations [theory 8.2].

#include "contact/law/interface_law.hpp"
#include "contact/point/local.hpp"

namespace signorini::contact {

/// The residual c of the conditions at a point and its derivatives; without friction only the first row and column.
/// The traction of the multiplier λ is λ + c, without friction along n̄.
template <int D> struct PointCondition {
  ContactState state = ContactState::open;
  Vec<D> residual = Vec<D>::Zero();
  Mat<D> of_multiplier = Mat<D>::Zero();
  LocalBlock<D> rows = LocalBlock<D>::Zero(); ///< with respect to the local variables
  double slipped = 0;                         ///< Δγ of a point that slips: (|y| − μ q)/ε_T
  double mu = 0;                              ///< see Slide
  FrictionFlaw flaw = FrictionFlaw::none;     ///< see Slide
  double worn = 0;                            ///< depth by which the point wears in the step
};

/// An open point: c = −λ.
template <int D> PointCondition<D> open_condition(const Vec<D>& multiplier, bool frictional);

/// A closed point, without friction (λ a pressure) c = −ε_N (g − o), with friction (λ a traction on the slave, v the
/// slip)
///   c = q n̄ − P(y) − λ,   q = n̄·λ − ε_N (g − o),   y = T (ε_T v − λ),   T = I − n̄ n̄ᵀ,
/// where P returns y to |y| ≤ μ q (P. Alart, A. Curnier, CMAME 92, 1991).
template <int D>
PointCondition<D> closed_condition(const InterfaceLaw& law, const LocalGeometry<D>& geometry, const Vec<D>& multiplier,
                                   bool frictional, const GapRows<D>& gap, const LocalShift<D>& shift);

} // namespace signorini::contact
