#pragma once
// Compressible neo-Hookean law.

#include "solid/material.hpp"

namespace signorini::solid {

/// W = λ/2 (ln J)² + μ/2 (tr C − 3) − μ ln J P = μ(F − F⁻ᵀ) + λ ln J F⁻ᵀ [theory 2.2].
struct NeoHookean : ElasticConstants {
  static constexpr auto name = "neo-Hooke";
  static constexpr bool linear = false;
  double energy(const Mat<3>& f) const;
  Mat<3> stress(const Mat<3>& f) const;
  Moduli moduli(const Mat<3>& f) const;
  template <int D> static Kernels kernels(Kind kind, int functions);
};

/// Throws Error unless E > 0 and −1 < ν < 0.5.
inline NeoHookean neo_hookean(double youngs_modulus, double poissons_ratio) {
  return {elastic_constants(youngs_modulus, poissons_ratio)};
}

extern template Material::Material(NeoHookean);

} // namespace signorini::solid
