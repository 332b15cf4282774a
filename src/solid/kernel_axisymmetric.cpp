#include "solid/kernel.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::solid {

namespace {

/// K^{ij}_{AB} += b g_jA g_iB + λ d_iA d_jB + δ_ir δ_jr (μ + b/s²) (R_A/R)(R_B/R) at one Gauss point, where g are the
/// current gradients and d_iA = g_iA + δ_ir R_A/(R s) is ∂(ln J)/∂u_iA.
void add_tangent(int n, double bracket, double lambda, double mu, double stretch, const double* current,
                 const double* hoop, double* blocks) {
  const double hoops = mu + bracket / (stretch * stretch);
  for (int i = 0; i < 2; ++i)
    for (int j = i; j < 2; ++j) {
      const double *gi = current + i * n, *gj = current + j * n;
      const double first = i == 0 ? 1 / stretch : 0, second = j == 0 ? 1 / stretch : 0;
      for (int a = 0; a < n; ++a, blocks += n) {
        const double geometric = bracket * gj[a], volumetric = lambda * (gi[a] + first * hoop[a]);
        const double around = j == 0 ? hoops * hoop[a] : 0;
        for (int b = 0; b < n; ++b)
          blocks[b] += geometric * gi[b] + volumetric * (gj[b] + second * hoop[b]) + around * hoop[b];
      }
    }
}

} // namespace

// In the directions (r, z, θ), F = [F₂ 0; 0 s] with F₂ = I + Σ_A u_A ⊗ ∇R_A in the meridian plane and the hoop stretch
// s = r/R = 1 + Σ_A u_rA R_A/R, so that J = s det F₂. The law in space gives
//   P₂ = μ F₂ − b F₂⁻ᵀ, P_θθ = μ s − b/s, b = μ − λ ln J,
// the virtual work ∫ P₂:δF₂ + P_θθ δs dV gives the forces
//   f_iA = ∫ P_ik ∂R_A/∂X_k + δ_ir P_θθ R_A/R dV,
// and ∂b = −λ ∂(ln J), ∂(F₂⁻ᵀ) = −F₂⁻ᵀ ∂F₂ᵀ F₂⁻ᵀ give the tangent
//   ∂P₂ = μ ∂F₂ + b F₂⁻ᵀ ∂F₂ᵀ F₂⁻ᵀ + λ ∂(ln J) F₂⁻ᵀ, ∂P_θθ = (μ + b/s²) ∂s + λ ∂(ln J)/s,
// whose first term is constant [theory 2.7].
KernelResult axisymmetric_kernel(const KernelArguments& in) {
  const int n = in.functions;
  const double *gradients = in.gradients, *hoop = in.hoop;
  std::fill_n(in.force, 2 * n, 0.0);
  if (in.blocks) {
    std::copy_n(in.constant, n * n, in.blocks);
    std::fill_n(in.blocks + n * n, n * n, 0.0);
    std::copy_n(in.constant, n * n, in.blocks + 2 * n * n);
  }
  for (int q = 0; q < in.points; ++q, gradients += 2 * n, hoop += n) {
    double f[2][2] = {{1, 0}, {0, 1}}, stretch = 1;
    for (int a = 0; a < n; ++a) {
      for (int i = 0; i < 2; ++i)
        for (int k = 0; k < 2; ++k) f[i][k] += in.local[i * n + a] * gradients[k * n + a];
      stretch += in.local[a] * hoop[a];
    }
    const double plane = f[0][0] * f[1][1] - f[0][1] * f[1][0], weight = in.weights[q];
    if (!(plane > 0)) return {q, plane};
    if (!(stretch > 0)) return {q, stretch};
    const double inverse[2][2] = {{f[1][1] / plane, -f[0][1] / plane}, {-f[1][0] / plane, f[0][0] / plane}};
    const double mu = weight * in.mu, lambda = weight * in.lambda, bracket = mu - lambda * std::log(plane * stretch);
    const double around = mu * stretch - bracket / stretch;
    for (int i = 0; i < 2; ++i) {
      const double p0 = mu * f[i][0] - bracket * inverse[0][i], p1 = mu * f[i][1] - bracket * inverse[1][i];
      for (int a = 0; a < n; ++a) {
        in.force[i * n + a] += p0 * gradients[a] + p1 * gradients[n + a] + (i == 0 ? around * hoop[a] : 0);
        in.work[i * n + a] = inverse[0][i] * gradients[a] + inverse[1][i] * gradients[n + a];
      }
    }
    const double geometric = in.predicted ? bracket - lambda * in.predicted[q] : bracket;
    if (in.blocks) add_tangent(n, geometric, lambda, mu, stretch, in.work, hoop, in.blocks);
  }
  return {-1, 1};
}

} // namespace signorini::solid
