#pragma once
// Constitutive laws: energy and stress as sibling free functions.

#include "base/eigen.hpp"

#include <variant>

namespace signorini::solid {

/// What an isotropic elastic law is given, and Lamé's constants that follow from it.
struct ElasticConstants {
  double youngs_modulus; ///< E > 0, force per area
  double poissons_ratio; ///< −1 < ν < 0.5
  double lambda;         ///< λ = 2μν/(1 − 2ν)
  double mu;             ///< μ = E/(2(1 + ν))
};

/// Compressible neo-Hooke, W = λ/2 (ln J)² + μ/2 (tr C − 3) − μ ln J (thesis eq. 3.29). In 2D: plane strain, F₃₃ = 1.
struct NeoHookean : ElasticConstants {};

/// Hooke's law of small strains, W = λ/2 (tr ε)² + μ ε:ε with ε = sym(F − I); all stress measures are one. In 2D: plane
/// strain, ε₃₃ = 0.
struct LinearElastic : ElasticConstants {};

using Material = std::variant<NeoHookean, LinearElastic>;

/// Both throw Error unless E > 0 and −1 < ν < 0.5.
NeoHookean neo_hookean(double youngs_modulus, double poissons_ratio);
LinearElastic linear_elastic(double youngs_modulus, double poissons_ratio);

const ElasticConstants& constants(const Material& material);

/// Stored energy per reference volume. `deformation` is F, with positive determinant where the law is neo-Hooke's.
template <int D> double energy(const NeoHookean& material, const Mat<D>& deformation);
template <int D> double energy(const LinearElastic& material, const Mat<D>& deformation);
template <int D> double energy(const Material& material, const Mat<D>& deformation);

/// First Piola–Kirchhoff stress ∂W/∂F: neo-Hooke P = μ(F − F⁻ᵀ) + λ ln J F⁻ᵀ, Hooke P = λ tr ε I + 2μ ε.
template <int D> Mat<D> first_piola_stress(const NeoHookean& material, const Mat<D>& deformation);
template <int D> Mat<D> first_piola_stress(const LinearElastic& material, const Mat<D>& deformation);
template <int D> Mat<D> first_piola_stress(const Material& material, const Mat<D>& deformation);

/// Cauchy stress, always 3×3: neo-Hooke σ = (λ/J) ln J I + (μ/J)(F Fᵀ − I), plane strain has σ₃₃ = (λ/J) ln J;
/// Hooke σ = λ tr ε I + 2μ ε, plane strain has σ₃₃ = λ tr ε.
template <int D> Mat<3> cauchy_stress(const NeoHookean& material, const Mat<D>& deformation);
template <int D> Mat<3> cauchy_stress(const LinearElastic& material, const Mat<D>& deformation);
template <int D> Mat<3> cauchy_stress(const Material& material, const Mat<D>& deformation);

/// F in space of a plane deformation and the stretch F₃₃ across: of the hoops where the body is one of revolution
/// (directions r, z, θ), 1 in plane strain.
Mat<3> in_space(const Mat<2>& deformation, double hoop);

} // namespace signorini::solid
