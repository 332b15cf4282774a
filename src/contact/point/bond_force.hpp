#pragma once
// Bond at one contact point: its two shares in the forces with their consistent tangents [theory 9.3].

#include "contact/law/cohesion.hpp"
#include "contact/point/local.hpp"

namespace signorini::contact {

/// A bond between a slave point and xᵐ(ξ⁰), the master's point next to it in the initial state, with
///   Δ = xˢ − xᵐ(ξ⁰),   δ² = |Δ|² − g²  where the point is closed,   δ² = |Δ|²  elsewhere.
/// On a flat master δ² = ⟨Δ_n⟩² + |Δ_t|²: pressure neither opens the bond nor acts against it.
template <int D> struct Bond {
  Vec<D> apart;                   ///< Δ
  bool closed = false;            ///< the penalty acts
  double gap = 0;                 ///< g, if closed
  Vec<D> normal = Vec<D>::Zero(); ///< n̄ at the closest point, if closed
  double largest = 0;             ///< opening so far
  double opening() const;         ///< δ
};

/// Force of the spring k between the two points, T = −k Δ on the slave, from the energy ½ k δ² at constant k. In
/// `result` the master is the point xᵐ(ξ⁰), and the slip point, if closed, the closest point x̄ᵐ.
template <int D>
void spring_force(const Bond<D>& bond, const Separation& separation, double measure, LocalForce<D>& result);
/// The rest of the energy's derivative at a closed point, the traction k g n̄ at the closest point, which cancels the
/// spring's normal part; the slip point is xᵐ(ξ⁰).
template <int D>
void relief_force(const Bond<D>& bond, const Separation& separation, const LocalGeometry<D>& geometry,
                  LocalForce<D>& result);
/// δδ with respect to the local variables of the two.
template <int D> LocalRow<D> opening_row(const Bond<D>& bond, bool about_spring);

} // namespace signorini::contact
