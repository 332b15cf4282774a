#include "solid/stability.hpp"

#include "base/dense.hpp"
#include "solid/energy.hpp"
#include "solid/projected_volume.hpp"

namespace signorini::solid {

namespace {

/// F at a Gauss point, F̄ if the volume change is projected.
template <int D>
Mat<3> deformation_at_point(const Body<D>& body, int e, int q, const double* displacement, ProjectedVolume<D>& volume) {
  const std::span<const int> functions = body.tables().functions_of(e);
  const int n = std::ssize(functions);
  const double *gradients = body.tables().gradients_of(e) + q * D * n, *hoops = body.tables().hoops_of(e);
  Mat<D> f = Mat<D>::Identity();
  double across = 1;
  for (int a = 0; a < n; ++a) {
    const Eigen::Map<const Vec<D>> u(displacement + D * functions[a]);
    for (int k = 0; k < D; ++k) f.col(k) += u * gradients[k * n + a];
    if (hoops) across += u(0) * hoops[q * n + a];
  }
  if constexpr (D == 2)
    if (body.kind() == Kind::plane_stress) across = body.material().thickness_stretch(f);
  const Mat<3> result = in_space<D>(f, across);
  if (body.volumetric() == Volumetric::pointwise) return result;
  return dilated(body.small_strains(), result, volume.change_at(body, e, q, result, displacement));
}

} // namespace

// With a_ijkl = ∂P_iJ/∂F_kL F_jJ F_lL and τ = P Fᵀ these moduli are a_ijkl + δ_ik τ_jl, symmetrized [theory 2.5].
double least_modulus(const Hyperelastic& law, const Mat<3>& f) {
  const Moduli moduli = law.moduli(f);
  const Mat<3> kirchhoff = law.stress(f) * f.transpose();
  Moduli forward = Moduli::Zero(); // row 3i + J to 3i + j
  for (int i = 0; i < 3; ++i) forward.block<3, 3>(3 * i, 3 * i) = f;
  Moduli spatial = forward * moduli * forward.transpose();
  for (int i = 0; i < 3; ++i) spatial.block<3, 3>(3 * i, 3 * i) += kirchhoff;
  return dense::symmetric_eigenvalues(strain_moduli(spatial))(0);
}

template <int D> std::optional<Instability> unstable_point(const Body<D>& body, const double* displacement) {
  constexpr int most_points = 256;
  constexpr double rounding = 1e-9; // of the initial shear modulus
  const Hyperelastic* law = hyperelastic_law(body.material());
  if (!law) return std::nullopt;
  const int stride = (body.elements() + most_points - 1) / most_points;
  double least = -rounding * law->mu;
  std::optional<Instability> worst;
  ProjectedVolume<D> volume;
  for (int e = 0; e < body.elements(); e += stride) {
    const int q = body.tables().element(e).points / 2;
    const Mat<3> f = deformation_at_point(body, e, q, displacement, volume);
    const double modulus = least_modulus(*law, f);
    if (!(modulus < least)) continue;
    least = modulus;
    const std::vector<double> stretches = stretches_of(f);
    worst = Instability{Vec<3>(stretches[0], stretches[1], stretches[2]), reference_point(body, e, q)};
  }
  return worst;
}

template std::optional<Instability> unstable_point(const Body<2>&, const double*);
template std::optional<Instability> unstable_point(const Body<3>&, const double*);

} // namespace signorini::solid
