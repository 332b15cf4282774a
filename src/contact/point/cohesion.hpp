#pragma once
// Cohesive law of a bond at one contact point: traction over opening with irreversible damage, and its two shares in
// the forces with their consistent tangents [theory 9.3].

#include "contact/point/local.hpp"

namespace signorini::contact {

/// How the traction T falls with the opening δ of a bond that opens for the first time.
enum class Softening : unsigned char {
  exponential, ///< T = e σ_c (δ/δ_c) exp(−δ/δ_c), G_c = e σ_c δ_c (M. Ortiz, A. Pandolfi, IJNME 44, 1999)
  bilinear     ///< T = K δ up to σ_c, then linear to zero at δ_f = 2 G_c/σ_c
};

/// Tractions are forces per reference area of the slave.
struct Cohesion {
  double strength; ///< σ_c > 0, largest traction
  double energy;   ///< G_c > 0, of complete separation per area
  Softening softening = Softening::exponential;
  double stiffness = 0; ///< K > 0 of a bilinear law, pressure per length; 0 in a scene: the contact's penalty
};

/// Throws Error if a constant is invalid, or if a bilinear law would snap back: δ_f ≤ σ_c/K.
void check(const Cohesion& law);
/// Opening at the largest traction: δ_c of the exponential law, δ₀ = σ_c/K of the bilinear one.
double strongest_opening(const Cohesion& law);

/// A bond whose opening is δ and was at most δ_m before. It closes along the secant, T = k δ with k at max(δ, δ_m).
struct Separation {
  double stiffness;   ///< k = T/δ, pressure per length
  double rate;        ///< dk/dδ, zero where the opening is below its largest value
  double damage;      ///< d = 1 − k/k(0)
  double damage_rate; ///< dd/dδ
  double dissipated;  ///< energy per area that has not been recovered at δ = 0; G_c where the bond is broken
};
Separation separate(const Cohesion& law, double opening, double largest);

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
