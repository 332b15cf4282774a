#pragma once
// Bond at one contact point: its two shares in the forces with their consistent tangents [theory 9.3].

#include "contact/law/cohesion.hpp"
#include "contact/point/local.hpp"

namespace signorini::contact {

/// A bond between a slave point and xᵐ(ξ⁰), the master's point next to it in the initial state, with
///   Δ = xˢ − xᵐ(ξ⁰),   δ² = |Δ|² − g²  where the point is closed,   δ² = |Δ|²  elsewhere.
/// On a flat master δ² = ⟨Δ_n⟩² + |Δ_t|²: pressure neither opens the bond nor acts against it. Where shear counts
/// differently, with a weight b or by a mode mix m, an open bond has with the master's normal n at ξ⁰
///   Δ_n = n·Δ,   δ² = b² |Δ|² + (1 − b²) Δ_n²,   m = 1 − Δ_n²/δ²,
/// and a closed one b² (|Δ|² − g²) and m = 1.
template <int D> struct Bond {
  Vec<D> apart;                   ///< Δ
  bool closed = false;            ///< the penalty acts
  double gap = 0;                 ///< g, if closed
  Vec<D> normal = Vec<D>::Zero(); ///< n̄ at the closest point, if closed; of a split bond n
  double weight = 1;              ///< b²
  const FacePoint<D>* split = {}; ///< xᵐ(ξ⁰) with its tangents, if opening and shear are told apart; null if closed
  double opening() const;         ///< δ
  double mix() const;             ///< m
  Vec<D> pull() const;            ///< v of the spring's traction −k v, b² Δ + (1 − b²) Δ_n n
};

/// Force of the spring k between the two points, −k v on the slave, from the energy ½ k δ² at constant k and n. In
/// `result` the master is the point xᵐ(ξ⁰), and the slip point, if closed, the closest point x̄ᵐ.
template <int D>
void spring_force(const Bond<D>& bond, const Separation& separation, double measure, LocalForce<D>& result);
/// The rest of the energy's derivative at a closed point, the traction k b² g n̄ at the closest point, which cancels the
/// spring's normal part; the slip point is xᵐ(ξ⁰).
template <int D>
void relief_force(const Bond<D>& bond, const Separation& separation, const LocalGeometry<D>& geometry,
                  LocalForce<D>& result);
/// δδ with respect to the local variables of the two.
template <int D> LocalRow<D> opening_row(const Bond<D>& bond, bool about_spring);

} // namespace signorini::contact
