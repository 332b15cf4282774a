#pragma once
// Cohesive law of a bond: traction over opening with irreversible damage [theory 9.3].

#include "contact/law/cohesion_formula.hpp"

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
  /// In place of all that; strength and energy are then those of the formula in pure opening.
  std::shared_ptr<const CohesionFormula> formula = {};
};

Cohesion cohesive(std::shared_ptr<const CohesionFormula> formula);
/// b: by how much more than an opening a shear of the same size counts.
inline double shear_weight(const Cohesion& law) {
  return law.formula ? law.formula->shear : 1;
}
/// True if opening and shear count differently, so that a bond needs the direction of the face.
inline bool tells_shear(const Cohesion& law) {
  return law.formula && (law.formula->mixed || law.formula->shear != 1);
}

/// Throws Error if a constant is invalid, or if a bilinear law would snap back: δ_f ≤ σ_c/K.
void check(const Cohesion& law);
/// Opening at the largest traction: δ_c of the exponential law, δ₀ = σ_c/K of the bilinear one.
double strongest_opening(const Cohesion& law);

/// A bond whose opening is δ and was at most δ_m before. It closes along the secant, T = k δ with k at max(δ, δ_m). One
/// by formula, whose openings of different mixtures do not compare, closes with the fraction of its stiffness that is
/// `left`.
struct Separation {
  double stiffness;   ///< k = T/δ, pressure per length
  double rate;        ///< dk/dδ, zero where the opening is below its largest value
  double damage;      ///< d = 1 − k/k(0)
  double damage_rate; ///< dd/dδ
  double dissipated;  ///< energy per area that has not been recovered at δ = 0, G_c where the bond is broken; not by
                      ///< formula
  double of_mix = 0;  ///< dk/dm
  double left = 1;    ///< k/k(0) by formula
};
Separation separate(const Cohesion& law, double opening, double largest, double mix = 0, double left = 1);

} // namespace signorini::contact
