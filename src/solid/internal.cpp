#include "solid/internal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::solid {

namespace {

/// F = I + Σ_A u_A ⊗ ∇R_A; from displacements, so that the rounding is relative to the strain and not to the position.
template <int D> Mat<D> deformation_gradient(const double* local, const double* gradients, int n) {
  Mat<D> f = Mat<D>::Identity();
  for (int i = 0; i < D; ++i)
    for (int k = 0; k < D; ++k) {
      double sum = 0;
      for (int a = 0; a < n; ++a) sum += local[i * n + a] * gradients[k * n + a];
      f(i, k) += sum;
    }
  return f;
}

template <int D> void gather(const Body<D>& body, int e, const double* displacement, double* local) {
  const auto functions = body.functions_of(e);
  const int n = static_cast<int>(functions.size());
  for (int a = 0; a < n; ++a)
    for (int i = 0; i < D; ++i) local[i * n + a] = displacement[D * functions[static_cast<std::size_t>(a)] + i];
}

} // namespace

template <int D>
std::optional<Inversion> internal_force(const Body<D>& body, int e, const double* displacement,
                                        ElementArrays<D>& arrays) {
  const ElementTable& table = body.element(e);
  const int n = table.functions, square = n * n;
  const double lambda = body.material().lambda, mu = body.material().mu;
  double* local = arrays.local.data();
  double* current = local + D * n; // g_iA = F⁻ᵀ ∇R_A, the gradients in the current configuration
  double* force = arrays.force.data();
  gather(body, e, displacement, local);
  std::fill_n(force, D * n, 0.0);
  for (int i = 0, block = 0; i < D; ++i)
    for (int j = i; j < D; ++j, ++block) {
      double* k = arrays.blocks.data() + block * square;
      // ∫ μ ∇R_A·∇R_B dV, the part of the diagonal blocks that never changes
      if (i == j)
        std::copy_n(body.constant_of(e), square, k);
      else
        std::fill_n(k, square, 0.0);
    }

  const double* gradients = body.gradients_of(e);
  for (int q = 0; q < table.points; ++q, gradients += D * n) {
    const double weight = body.weights_of(e)[q];
    const Mat<D> f = deformation_gradient<D>(local, gradients, n);
    const double j = f.determinant();
    if (!(j > 0)) return Inversion{e, body.reference_point(e, q), j};
    const double log_j = std::log(j);
    const Mat<D> inverse = f.inverse();

    // P = μ F − (μ − λ ln J) F⁻ᵀ
    const double bracket = mu - lambda * log_j;
    const Mat<D> stress = weight * (mu * f - bracket * inverse.transpose());
    for (int i = 0; i < D; ++i)
      for (int k = 0; k < D; ++k) {
        const double p = stress(i, k), h = inverse(k, i);
        const double* row = gradients + k * n;
        double* g = current + i * n;
        for (int a = 0; a < n; ++a) {
          force[i * n + a] += p * row[a];
          g[a] = (k == 0 ? 0.0 : g[a]) + h * row[a];
        }
      }

    // K^{ij}_{AB} = ∫ μ ∇R_A·∇R_B δ_ij + (μ − λ ln J) g_jA g_iB + λ g_iA g_jB dV,
    // from ∂P = μ ∂F + (μ − λ ln J) F⁻ᵀ ∂Fᵀ F⁻ᵀ + λ (F⁻ᵀ:∂F) F⁻ᵀ
    const double geometric = weight * bracket, volumetric = weight * lambda;
    for (int i = 0, block = 0; i < D; ++i)
      for (int l = i; l < D; ++l, ++block) {
        double* k = arrays.blocks.data() + block * square;
        const double* gi = current + i * n;
        const double* gl = current + l * n;
        if (i == l) {
          for (int a = 0; a < n; ++a) {
            const double factor = (geometric + volumetric) * gi[a];
            for (int b = 0; b < n; ++b) k[a * n + b] += factor * gi[b];
          }
        } else {
          for (int a = 0; a < n; ++a) {
            const double first = geometric * gl[a], second = volumetric * gi[a];
            for (int b = 0; b < n; ++b) k[a * n + b] += first * gi[b] + second * gl[b];
          }
        }
      }
  }
  return std::nullopt;
}

template <int D> double stored_energy(const Body<D>& body, const double* displacement) {
  std::vector<double> local(static_cast<std::size_t>(D * body.most_functions()));
  double sum = 0;
  for (int e = 0; e < body.elements(); ++e) {
    const ElementTable& table = body.element(e);
    gather(body, e, displacement, local.data());
    for (int q = 0; q < table.points; ++q) {
      const Mat<D> f =
          deformation_gradient<D>(local.data(), body.gradients_of(e) + q * D * table.functions, table.functions);
      if (!(f.determinant() > 0)) return std::numeric_limits<double>::infinity();
      sum += body.weights_of(e)[q] * energy<D>(body.material(), f);
    }
  }
  return sum;
}

template std::optional<Inversion> internal_force<2>(const Body<2>&, int, const double*, ElementArrays<2>&);
template std::optional<Inversion> internal_force<3>(const Body<3>&, int, const double*, ElementArrays<3>&);
template double stored_energy<2>(const Body<2>&, const double*);
template double stored_energy<3>(const Body<3>&, const double*);

} // namespace signorini::solid
