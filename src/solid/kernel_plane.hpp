#pragma once
// The element kernel in the plane, for a number of functions known at compile time (N) or not (N = 0). Included by the
// files that compile it for different instruction sets; everything is local to them and no inline functions of other
// files are called, so that the linker cannot select a copy that an older machine is unable to run.

#include "solid/kernel.hpp"

#include <cmath>

namespace signorini::solid {

namespace {

/// Returns the determinant of F and computes its inverse, row by row.
inline double invert_plane(const double* f, double* inverse) {
  const double j = f[0] * f[3] - f[1] * f[2], scale = 1 / j;
  inverse[0] = f[3] * scale;
  inverse[1] = -f[1] * scale;
  inverse[2] = -f[2] * scale;
  inverse[3] = f[0] * scale;
  return j;
}

/// F_ik = δ_ik + Σ_A u_iA ∂R_A/∂X_k; from displacements, so that rounding errors are relative to the strain, not the
/// position.
template <int N> void deformation(const double* local, const double* gradients, int count, double* f) {
  const int n = N > 0 ? N : count;
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 2; ++k) {
      double sum = i == k ? 1 : 0;
      for (int a = 0; a < n; ++a) sum += local[i * n + a] * gradients[k * n + a];
      f[2 * i + k] = sum;
    }
}

/// f_iA += P_ik ∂R_A/∂X_k (P times the point's weight; the first point initializes the sum) and the current gradients
/// g_iA = (F⁻¹)_ki ∂R_A/∂X_k.
template <int N>
void push_forward(const double* stress, const double* inverse, const double* __restrict gradients, int count,
                  bool first, double* __restrict force, double* __restrict current) {
  const int n = N > 0 ? N : count;
  for (int i = 0; i < 2; ++i)
    for (int a = 0; a < n; ++a) {
      double p = first ? 0 : force[i * n + a], g = 0;
      for (int k = 0; k < 2; ++k) {
        p += stress[2 * i + k] * gradients[k * n + a];
        g += inverse[2 * k + i] * gradients[k * n + a];
      }
      force[i * n + a] = p;
      current[i * n + a] = g;
    }
}

/// K^{ij}_{AB} = δ_ij constant_AB + Σ_q c_q g_jA g_iB + v_q g_iA g_jB for i ≤ j, one n×n block after the other; the
/// sums over the Gauss points stay in registers.
template <int N>
void tangent(const double* __restrict current, const double* __restrict factors, const double* constant, int points,
             int count, double* __restrict blocks) {
  const int n = N > 0 ? N : count;
  constexpr int most = N > 0 ? N : 16 * 16 * 4; // more than any element of the highest degree in the plane has
  for (int i = 0; i < 2; ++i)
    for (int j = i; j < 2; ++j)
      for (int a = 0; a < n; ++a, blocks += n) {
        double sum[most];
        for (int b = 0; b < n; ++b) sum[b] = i == j ? constant[a * n + b] : 0.0;
        const double* g = current;
        for (int q = 0; q < points; ++q, g += 2 * n) {
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

template <int N> KernelResult run_plane(const KernelArguments& in) {
  const int n = N > 0 ? N : in.functions;
  double f[4], inverse[4], stress[4];
  const double* gradients = in.gradients;
  double* current = in.work;
  for (int q = 0; q < in.points; ++q, gradients += 2 * n, current += 2 * n) {
    deformation<N>(in.local, gradients, n, f);
    const double j = invert_plane(f, inverse), weight = in.weights[q];
    if (!(j > 0)) return {q, j};
    const double bracket = in.mu - in.lambda * std::log(j);
    // P = μ F − (μ − λ ln J) F⁻ᵀ
    for (int i = 0; i < 2; ++i)
      for (int k = 0; k < 2; ++k) stress[2 * i + k] = weight * (in.mu * f[2 * i + k] - bracket * inverse[2 * k + i]);
    push_forward<N>(stress, inverse, gradients, n, q == 0, in.force, current);
    in.factors[2 * q] = weight * (in.predicted ? bracket - in.lambda * in.predicted[q] : bracket);
    in.factors[2 * q + 1] = weight * in.lambda;
  }
  // K^{ij}_{AB} = ∫ μ ∇R_A·∇R_B δ_ij + (μ − λ ln J) g_jA g_iB + λ g_iA g_jB dV,
  // from ∂P = μ ∂F + (μ − λ ln J) F⁻ᵀ ∂Fᵀ F⁻ᵀ + λ (F⁻ᵀ:∂F) F⁻ᵀ; the first term is constant [theory 2.8].
  if (in.blocks) tangent<N>(in.work, in.factors, in.constant, in.points, n, in.blocks);
  return {-1, 1};
}

template <int... N> Kernel plane_kernel_of(int functions) {
  Kernel kernel = run_plane<0>;
  ((kernel = functions == N ? run_plane<N> : kernel), ...);
  return kernel;
}

/// Compiled for the usual elements that are linear in the thickness direction: (p+1) + (q+1) functions.
inline Kernel plane_kernel(int functions) {
  return plane_kernel_of<4, 5, 6, 7, 8, 9, 10, 12, 14>(functions);
}

} // namespace

} // namespace signorini::solid
