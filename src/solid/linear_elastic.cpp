#include "solid/linear_elastic.hpp"

#include "solid/neo_hookean.hpp"

#include <algorithm>

namespace signorini::solid {

double LinearElastic::energy(const Mat<3>& f) const {
  return 0.5 * stress(f).cwiseProduct(f - Mat<3>::Identity()).sum();
}

Mat<3> LinearElastic::stress(const Mat<3>& f) const {
  const Mat<3> strain = 0.5 * (f + f.transpose()) - Mat<3>::Identity();
  return lambda * strain.trace() * Mat<3>::Identity() + 2 * mu * strain;
}

Moduli LinearElastic::moduli(const Mat<3>&) const {
  // ∂P_ik/∂F_jl = λ δ_ik δ_jl + μ (δ_ij δ_kl + δ_il δ_kj)
  return moduli_of([&](int i, int k, int j, int l) {
    return lambda * (i == k && j == l) + mu * ((i == j && k == l) + (i == l && k == j));
  });
}

namespace {

/// The stiffness of a solid, which equals neo-Hooke's tangent at zero strain.
KernelResult stiffness_in_space(const KernelArguments& in) {
  const Kernels rubber = NeoHookean::kernels<3>(Kind::plane_strain, in.functions);
  const std::size_t n = in.functions, points = in.points;
  std::vector<double> shear(n * n + vector_padding), work(working_size(3, n, points)), factors(2 * points);
  KernelArguments at_rest = in;
  at_rest.blocks = shear.data();
  rubber.constant(at_rest);
  at_rest.constant = shear.data();
  at_rest.blocks = in.blocks;
  at_rest.work = work.data();
  at_rest.factors = factors.data();
  return rubber.element(at_rest);
}

/// K^{ij}_{AB} = ∫ λ ∂_iR_A ∂_jR_B + μ ∂_jR_A ∂_iR_B + δ_ij μ ∇R_A·∇R_B dV in the plane, for N functions if known when
/// compiled.
template <int N> KernelResult stiffness_in_plane(const KernelArguments& in) {
  using Row = Eigen::Array<double, N, 1>;
  const int n = in.functions;
  for (int a = 0; a < n; ++a) {
    Eigen::Map<Row> xx(in.blocks + a * n, n), xy(in.blocks + (n + a) * n, n), yy(in.blocks + (2 * n + a) * n, n);
    for (int q = 0; q < in.points; ++q) {
      const Eigen::Map<const Row> x(in.gradients + q * 2 * n, n), y(in.gradients + (q * 2 + 1) * n, n);
      const double lambda = in.weights[q] * in.lambda, mu = in.weights[q] * in.mu;
      xx += (lambda + 2 * mu) * x(a) * x + mu * y(a) * y;
      xy += lambda * x(a) * y + mu * y(a) * x;
      yy += (lambda + 2 * mu) * y(a) * y + mu * x(a) * x;
    }
  }
  return {-1, 1};
}

/// σ₃₃ = 0 makes λ* = 2λμ/(λ + 2μ) of λ in the plane.
template <int N> KernelResult stiffness_in_plane_stress(const KernelArguments& in) {
  KernelArguments reduced = in;
  reduced.lambda = 2 * in.lambda * in.mu / (in.lambda + 2 * in.mu);
  return stiffness_in_plane<N>(reduced);
}

// K^{ij}_{AB} = ∫ λ d_iA d_jB + μ ∂_jR_A ∂_iR_B + δ_ij μ ∇R_A·∇R_B + δ_ir δ_jr 2μ (R_A/R)(R_B/R) dV from
// ∂ε:∂σ = λ (tr ∂ε)² + 2μ ∂ε:∂ε, with tr ε = Σ_A d_iA u_iA: d_iA = ∂R_A/∂X_i + δ_ir R_A/R.
KernelResult stiffness_of_revolution(const KernelArguments& in) {
  const int n = in.functions;
  for (int q = 0; q < in.points; ++q) {
    const double lambda = in.weights[q] * in.lambda, mu = in.weights[q] * in.mu;
    const double *gradients = in.gradients + q * 2 * n, *hoop = in.hoop + q * n;
    const auto dilation = [&](int i, int a) { return gradients[i * n + a] + (i == 0 ? hoop[a] : 0); };
    double* blocks = in.blocks;
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
  return {-1, 1};
}

/// f = K u, and K, which is `constant`. States cannot be inverted. For N functions, if known when compiled.
template <int D, int N> KernelResult apply_stiffness(const KernelArguments& in) {
  using Block = Eigen::Matrix<double, N, N, Eigen::RowMajor>;
  using Column = Eigen::Matrix<double, N, 1>;
  const int n = in.functions;
  std::fill_n(in.force, D * n, 0.0);
  const double* k = in.constant;
  const auto displacement = [&](int i) { return Eigen::Map<const Column>(in.local + i * n, n); };
  const auto force = [&](int i) { return Eigen::Map<Column>(in.force + i * n, n); };
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j, k += n * n) {
      // K^{ji} = (K^{ij})ᵀ; diagonal blocks are symmetric, and columns need no sums across a vector
      const Eigen::Map<const Block> block(k, n, n);
      if (i == j) {
        force(i) += block.transpose().lazyProduct(displacement(i));
      } else {
        force(i) += block.lazyProduct(displacement(j));
        force(j) += block.transpose().lazyProduct(displacement(i));
      }
    }
  if (in.blocks) std::copy(in.constant, k, in.blocks);
  return {-1, 1};
}

template <int N> Kernels plane_kernels(Kind kind) {
  const Kernel constant = kind == Kind::axisymmetric   ? stiffness_of_revolution
                          : kind == Kind::plane_stress ? stiffness_in_plane_stress<N>
                                                       : stiffness_in_plane<N>;
  return {apply_stiffness<2, N>, constant, 3};
}

} // namespace

/// Compiled for elements of degree 1 to 3 in every direction, or of degree 1 across.
template <> Kernels LinearElastic::kernels<2>(Kind kind, int functions) {
  if (functions == 4) return plane_kernels<4>(kind);
  if (functions == 6) return plane_kernels<6>(kind);
  if (functions == 9) return plane_kernels<9>(kind);
  if (functions == 16) return plane_kernels<16>(kind);
  return plane_kernels<Eigen::Dynamic>(kind);
}

template <> Kernels LinearElastic::kernels<3>(Kind, int functions) {
  Kernel element = apply_stiffness<3, Eigen::Dynamic>;
  if (functions == 8) element = apply_stiffness<3, 8>;
  if (functions == 18) element = apply_stiffness<3, 18>;
  if (functions == 27) element = apply_stiffness<3, 27>;
  return {element, stiffness_in_space, 6};
}

template Material::Material(LinearElastic);

} // namespace signorini::solid
