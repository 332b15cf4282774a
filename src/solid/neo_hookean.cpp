#include "solid/neo_hookean.hpp"

#include <cmath>

namespace signorini::solid {

double NeoHookean::energy(const Mat<3>& f) const {
  const double log_j = std::log(f.determinant());
  return 0.5 * lambda * log_j * log_j + 0.5 * mu * (f.squaredNorm() - 3) - mu * log_j;
}

Mat<3> NeoHookean::stress(const Mat<3>& f) const {
  const double log_j = std::log(f.determinant());
  return mu * f + (lambda * log_j - mu) * f.inverse().transpose();
}

Moduli NeoHookean::moduli(const Mat<3>& f) const {
  const Mat<3> inverse = f.inverse();
  const double bracket = mu - lambda * std::log(f.determinant());
  // ∂P_ik/∂F_jl = μ δ_ij δ_kl + (μ − λ ln J) F⁻¹_kj F⁻¹_li + λ F⁻¹_ki F⁻¹_lj [theory 2.2]
  return moduli_of([&](int i, int k, int j, int l) {
    return mu * (i == j && k == l) + bracket * inverse(k, j) * inverse(l, i) + lambda * inverse(k, i) * inverse(l, j);
  });
}

namespace {

/// Σ_q w μ ∇R_A·∇R_B, the first term of the tangent, which is constant: one n×n block.
template <int D> KernelResult shear_kernel(const KernelArguments& in) {
  const int n = in.functions;
  for (int q = 0; q < in.points; ++q) {
    const double *gradients = in.gradients + q * D * n, factor = in.weights[q] * in.mu;
    double* row = in.blocks;
    for (int a = 0; a < n; ++a, row += n)
      for (int k = 0; k < D; ++k) {
        const double left = factor * gradients[k * n + a];
        for (int b = 0; b < n; ++b) row[b] += left * gradients[k * n + b];
      }
  }
  return {-1, 1};
}

} // namespace

template <int D> Kernels NeoHookean::kernels(Kind kind, int functions) {
  if (kind == Kind::plane_stress) return moduli_kernels_of<NeoHookean, D>(kind);
  return {kind == Kind::axisymmetric ? axisymmetric_kernel : element_kernels<D>(functions).back(), shear_kernel<D>, 1};
}

template Kernels NeoHookean::kernels<2>(Kind, int);
template Kernels NeoHookean::kernels<3>(Kind, int);
template Material::Material(NeoHookean);

} // namespace signorini::solid
