// The element kernel's loops, for a number of functions that the compiler knows (N) or not (N = 0). Included by the two
// files that compile it; everything is local to them and calls no inline function of others, so that code for newer
// machines cannot end up where older ones run it.

#include "solid/kernel.hpp"

#include <cmath>

namespace signorini::solid {

namespace {

/// Determinant of F and its inverse, row by row.
template <int D> double invert(const double* f, double* inverse) {
  if constexpr (D == 2) {
    const double j = f[0] * f[3] - f[1] * f[2], scale = 1 / j;
    inverse[0] = f[3] * scale;
    inverse[1] = -f[1] * scale;
    inverse[2] = -f[2] * scale;
    inverse[3] = f[0] * scale;
    return j;
  } else {
    const double c0 = f[4] * f[8] - f[5] * f[7], c1 = f[5] * f[6] - f[3] * f[8], c2 = f[3] * f[7] - f[4] * f[6];
    const double j = f[0] * c0 + f[1] * c1 + f[2] * c2, scale = 1 / j;
    inverse[0] = c0 * scale;
    inverse[1] = (f[2] * f[7] - f[1] * f[8]) * scale;
    inverse[2] = (f[1] * f[5] - f[2] * f[4]) * scale;
    inverse[3] = c1 * scale;
    inverse[4] = (f[0] * f[8] - f[2] * f[6]) * scale;
    inverse[5] = (f[2] * f[3] - f[0] * f[5]) * scale;
    inverse[6] = c2 * scale;
    inverse[7] = (f[1] * f[6] - f[0] * f[7]) * scale;
    inverse[8] = (f[0] * f[4] - f[1] * f[3]) * scale;
    return j;
  }
}

/// F_ik = δ_ik + Σ_A u_iA ∂R_A/∂X_k; from displacements, so that rounding is relative to the strain, not the position.
template <int D, int N> void deformation(const double* local, const double* gradients, int count, double* f) {
  const int n = N > 0 ? N : count;
  for (int i = 0; i < D; ++i)
    for (int k = 0; k < D; ++k) {
      double sum = i == k ? 1 : 0;
      for (int a = 0; a < n; ++a) sum += local[i * n + a] * gradients[k * n + a];
      f[i * D + k] = sum;
    }
}

/// f_iA += P_ik ∂R_A/∂X_k (P times the point's weight; the first point starts the sum) and g_iA = (F⁻¹)_ki ∂R_A/∂X_k,
/// the current gradients.
template <int D, int N>
void push_forward(const double* stress, const double* inverse, const double* __restrict gradients, int count,
                  bool first, double* __restrict force, double* __restrict current) {
  const int n = N > 0 ? N : count;
  for (int i = 0; i < D; ++i)
    for (int a = 0; a < n; ++a) {
      double p = first ? 0 : force[i * n + a], g = 0;
      for (int k = 0; k < D; ++k) {
        p += stress[i * D + k] * gradients[k * n + a];
        g += inverse[k * D + i] * gradients[k * n + a];
      }
      force[i * n + a] = p;
      current[i * n + a] = g;
    }
}

/// K^{ij}_{AB} = δ_ij constant_AB + Σ_q c_q g_jA g_iB + v_q g_iA g_jB for i ≤ j, one n×n block after the other; the
/// sums over the Gauss points stay in registers.
template <int D, int N>
void tangent(const double* __restrict current, const double* __restrict factors, const double* constant, int points,
             int count, double* __restrict blocks) {
  const int n = N > 0 ? N : count;
  constexpr int most = N > 0 ? N : 16 * 16 * 4; // far above what any element of the highest degree in the plane holds
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j)
      for (int a = 0; a < n; ++a, blocks += n) {
        double sum[most];
        for (int b = 0; b < n; ++b) sum[b] = i == j ? constant[a * n + b] : 0.0;
        const double* g = current;
        for (int q = 0; q < points; ++q, g += D * n) {
          const double *gi = g + i * n, *gj = g + j * n;
          const double geometric = factors[2 * q], volumetric = factors[2 * q + 1];
          if (i == j) {
            const double factor = (geometric + volumetric) * gi[a];
            for (int b = 0; b < n; ++b) sum[b] += factor * gi[b];
          } else {
            const double first = geometric * gj[a], second = volumetric * gi[a];
            for (int b = 0; b < n; ++b) sum[b] += first * gi[b] + second * gj[b];
          }
        }
        for (int b = 0; b < n; ++b) blocks[b] = sum[b];
      }
}

template <int D, int N> KernelResult run(const KernelArguments& in) {
  const int n = N > 0 ? N : in.functions;
  double f[D * D], inverse[D * D], stress[D * D];
  const double* gradients = in.gradients;
  double* current = in.current;
  for (int q = 0; q < in.points; ++q, gradients += D * n, current += D * n) {
    deformation<D, N>(in.local, gradients, n, f);
    const double j = invert<D>(f, inverse), weight = in.weights[q];
    if (!(j > 0)) return {q, j};
    const double bracket = in.mu - in.lambda * std::log(j);
    // P = μ F − (μ − λ ln J) F⁻ᵀ
    for (int i = 0; i < D; ++i)
      for (int k = 0; k < D; ++k) stress[i * D + k] = weight * (in.mu * f[i * D + k] - bracket * inverse[k * D + i]);
    push_forward<D, N>(stress, inverse, gradients, n, q == 0, in.force, current);
    in.factors[2 * q] = weight * bracket;
    in.factors[2 * q + 1] = weight * in.lambda;
  }
  // K^{ij}_{AB} = ∫ μ ∇R_A·∇R_B δ_ij + (μ − λ ln J) g_jA g_iB + λ g_iA g_jB dV,
  // from ∂P = μ ∂F + (μ − λ ln J) F⁻ᵀ ∂Fᵀ F⁻ᵀ + λ (F⁻ᵀ:∂F) F⁻ᵀ; the first term never changes.
  if (in.blocks) tangent<D, N>(in.current, in.factors, in.constant, in.points, n, in.blocks);
  return {-1, 1};
}

/// Known at compile time: what plane bodies have that are linear through the body, (p+1) + (q+1) functions, and the
/// common solid elements.
template <int D> Kernel select(int functions) {
  switch (functions) {
  case 4:
    return run<D, 4>;
  case 5:
    return run<D, 5>;
  case 6:
    return run<D, 6>;
  case 7:
    return run<D, 7>;
  case 8:
    return run<D, 8>;
  case 9:
    return run<D, 9>;
  case 10:
    return run<D, 10>;
  case 12:
    return run<D, 12>;
  case 14:
    return run<D, 14>;
  case 18:
    return run<D, 18>;
  case 27:
    return run<D, 27>;
  default:
    return run<D, 0>;
  }
}

} // namespace

} // namespace signorini::solid
