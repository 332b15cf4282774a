#pragma once
// Hooke's law for small strains.

#include "solid/material.hpp"

namespace signorini::solid {

/// W = λ/2 (tr ε)² + μ ε:ε with ε = sym(F − I), P = λ tr ε I + 2μ ε [theory 2.3].
struct LinearElastic : ElasticConstants {
  static constexpr auto name = "linear elastic";
  static constexpr bool linear = true;
  double energy(const Mat<3>& f) const;
  Mat<3> stress(const Mat<3>& f) const;
  Moduli moduli(const Mat<3>& f) const;
  template <int D> static Kernels kernels(Kind kind, int functions);
};

template <> Kernels LinearElastic::kernels<2>(Kind kind, int functions);
template <> Kernels LinearElastic::kernels<3>(Kind kind, int functions);

/// Throws Error unless E > 0 and −1 < ν < 0.5.
inline LinearElastic linear_elastic(double youngs_modulus, double poissons_ratio) {
  return {elastic_constants(youngs_modulus, poissons_ratio)};
}

extern template Material::Material(LinearElastic);

} // namespace signorini::solid
