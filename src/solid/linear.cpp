#include "solid/linear.hpp"

#include <algorithm>
#include <vector>

namespace signorini::solid {

template <int D>
void rest_stiffness(const ElasticConstants& constants, int n, int points, const double* gradients,
                    const double* weights, const double* constant, double* blocks) {
  const std::size_t rows = D * static_cast<std::size_t>(n), count = static_cast<std::size_t>(points);
  const std::vector<double> rest(rows, 0.0);
  std::vector<double> force(rows), work(working_size(D, static_cast<std::size_t>(n), count)), factors(2 * count);
  element_kernels<D>(n).back()({n, points, constants.lambda, constants.mu, rest.data(), gradients, weights, nullptr,
                                constant, force.data(), work.data(), factors.data(), blocks});
}

void add_stiffness_of_revolution(const ElasticConstants& constants, double weight, int n, const double* gradients,
                                 const double* hoop, double* blocks) {
  const double lambda = weight * constants.lambda, mu = weight * constants.mu;
  // tr ε = Σ_A d_iA u_iA: d_iA = ∂R_A/∂X_i, and the hoop strain u_r/R adds R_A/R to d_rA
  const auto dilation = [&](int i, int a) { return gradients[i * n + a] + (i == 0 ? hoop[a] : 0); };
  // K^{ij}_{AB} = ∫ λ d_iA d_jB + μ ∂_jR_A ∂_iR_B + δ_ij μ ∇R_A·∇R_B + δ_ir δ_jr 2μ (R_A/R)(R_B/R) dV,
  // from ∂ε:∂σ = λ (tr ∂ε)² + 2μ ∂ε:∂ε
  for (int i = 0; i < 2; ++i)
    for (int j = i; j < 2; ++j)
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) {
          double sum = lambda * dilation(i, a) * dilation(j, b) + mu * gradients[j * n + a] * gradients[i * n + b];
          if (i == j)
            for (int k = 0; k < 2; ++k) sum += mu * gradients[k * n + a] * gradients[k * n + b];
          if (i == 0 && j == 0) sum += 2 * mu * hoop[a] * hoop[b];
          *blocks++ += sum;
        }
}

template <int D> KernelResult linear_kernel(const KernelArguments& in) {
  const int n = in.functions;
  std::fill_n(in.force, D * n, 0.0);
  const double* k = in.constant;
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j)
      for (int a = 0; a < n; ++a, k += n) {
        // K^{ji} = (K^{ij})ᵀ
        double sum = 0;
        for (int b = 0; b < n; ++b) sum += k[b] * in.local[j * n + b];
        in.force[i * n + a] += sum;
        if (i != j)
          for (int b = 0; b < n; ++b) in.force[j * n + b] += k[b] * in.local[i * n + a];
      }
  if (in.blocks) std::copy(in.constant, k, in.blocks);
  return {-1, 1};
}

template void rest_stiffness<2>(const ElasticConstants&, int, int, const double*, const double*, const double*,
                                double*);
template void rest_stiffness<3>(const ElasticConstants&, int, int, const double*, const double*, const double*,
                                double*);
template KernelResult linear_kernel<2>(const KernelArguments&);
template KernelResult linear_kernel<3>(const KernelArguments&);

} // namespace signorini::solid
