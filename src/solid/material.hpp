#pragma once
// Constitutive laws: energy, stress and what the element kernel needs, as sibling free functions.

#include "base/eigen.hpp"

namespace signorini::solid {

/// Compressible neo-Hooke, W = λ/2 (ln J)² + μ/2 (tr C − 3) − μ ln J (thesis eq. 3.29). In 2D: plane strain, F₃₃ = 1.
struct NeoHookean {
  double youngs_modulus; ///< E > 0, force per area
  double poissons_ratio; ///< −1 < ν < 0.5
  double lambda;         ///< λ = 2μν/(1 − 2ν)
  double mu;             ///< μ = E/(2(1 + ν))
};

/// Throws Error unless E > 0 and −1 < ν < 0.5.
NeoHookean neo_hookean(double youngs_modulus, double poissons_ratio);

/// Stored energy per reference volume. `deformation` is F with positive determinant.
template <int D> double energy(const NeoHookean& material, const Mat<D>& deformation);

/// First Piola–Kirchhoff stress P = μ(F − F⁻ᵀ) + λ ln J F⁻ᵀ.
template <int D> Mat<D> first_piola_stress(const NeoHookean& material, const Mat<D>& deformation);

/// Cauchy stress σ = (λ/J) ln J I + (μ/J)(F Fᵀ − I), always 3×3 (plane strain has σ₃₃ = (λ/J) ln J).
template <int D> Mat<3> cauchy_stress(const NeoHookean& material, const Mat<D>& deformation);

} // namespace signorini::solid
