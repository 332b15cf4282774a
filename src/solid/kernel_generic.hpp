#pragma once
// The element kernel for any law: plane strain, bodies of revolution and solids use the same code, as F is always 3×3.

#include "base/error.hpp"
#include "solid/respond_each.hpp"

#include <algorithm>

namespace signorini::solid {

/// Strains of one Gauss point by the element's functions: δF_entry = Σ_A δu_iA row_A for the rows r of component i.
template <int D> struct StrainRows {
  int functions;
  const double *gradients, *hoop; ///< hoop is null in plane strain and 3D
  /// ∂R_A/∂X_k for F_ik, and R_A/R of the radial displacement for the hoop stretch.
  int count(int i) const { return D + (hoop && i == 0 ? 1 : 0); }
  const double* row(int r) const { return r < D ? gradients + r * functions : hoop; }
  /// 3i + k for F_ik.
  int entry(int i, int r) const { return r < D ? 3 * i + r : 8; }
};

/// K^{ij}_{AB} += Σ_rs row_rA a(entry_ir, entry_js) row_sB for i ≤ j, where `a` holds the moduli times the weight.
template <int D> void add_tangent(const Moduli& a, const StrainRows<D>& rows, double* blocks) {
  const int n = rows.functions;
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j)
      for (int function = 0; function < n; ++function, blocks += n)
        for (int s = 0; s < rows.count(j); ++s) {
          double factor = 0;
          for (int r = 0; r < rows.count(i); ++r)
            factor += rows.row(r)[function] * a(rows.entry(i, r), rows.entry(j, s));
          const double* row = rows.row(s);
          for (int b = 0; b < n; ++b) blocks[b] += factor * row[b];
        }
}

/// in.law is a T. If the element is inverted, the Jacobian is det F of a solid, and in the plane that of the plane part
/// or, if a point of a body of revolution crossed the axis, the hoop stretch r/R: whichever is not positive.
template <Law T, int D> KernelResult generic_kernel(const KernelArguments& in) {
  const T& law = *static_cast<const T*>(in.law);
  const int n = in.functions;
  std::fill_n(in.force, D * n, 0.0);
  if (in.blocks) std::fill_n(in.blocks, D * (D + 1) / 2 * n * n, 0.0);
  for (int q = 0; q < in.points; ++q) {
    const StrainRows<D> rows{n, in.gradients + q * D * n, in.hoop ? in.hoop + q * n : nullptr};
    Mat<3> f = Mat<3>::Identity();
    for (int i = 0; i < D; ++i)
      for (int r = 0; r < rows.count(i); ++r) {
        double& sum = f(rows.entry(i, r) / 3, rows.entry(i, r) % 3);
        for (int a = 0; a < n; ++a) sum += in.local[i * n + a] * rows.row(r)[a];
      }
    if constexpr (!T::linear)
      for (double j : {Mat<D>(f.topLeftCorner<D, D>()).determinant(), D == 2 ? f(2, 2) : 1.0})
        if (!(j > 0)) return {q, j};
    const std::size_t variables = static_cast<std::size_t>(in.internal_variables), first = q * variables;
    const std::span<const double> committed(in.committed + first, variables);
    // f_iA = ∫ P_ik ∂R_A/∂X_k + δ_ir P_θθ R_A/R dV
    const Mat<3> p = in.weights[q] * stress(law, f, committed, std::span(in.trial + first, variables));
    for (int i = 0; i < D; ++i)
      for (int r = 0; r < rows.count(i); ++r) {
        const double factor = p(rows.entry(i, r) / 3, rows.entry(i, r) % 3);
        for (int a = 0; a < n; ++a) in.force[i * n + a] += factor * rows.row(r)[a];
      }
    if (in.blocks) add_tangent<D>(in.weights[q] * moduli(law, f, committed), rows, in.blocks);
  }
  return {-1, 1};
}

/// The kernels of a law: its own if it defines them, otherwise the generic one. Throws Error for plane stress of a law
/// with internal variables, or of a linear one without own kernels.
template <Law T, int D> Kernels law_kernels(Kind kind, int functions) {
  if constexpr (requires { T::template kernels<D>(kind, functions); }) {
    return T::template kernels<D>(kind, functions);
  } else {
    if constexpr (ElasticResponse<T> && !T::linear) {
      if (kind == Kind::plane_stress) return moduli_kernels_of<T, D>(kind);
    }
    require(kind != Kind::plane_stress, "solid.material.plane_stress", {{"material", T::name}});
    return {generic_kernel<T, D>, nullptr, 0};
  }
}

} // namespace signorini::solid
