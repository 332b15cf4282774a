#pragma once
// What the functions of an element contribute to F at one of its Gauss points.

namespace signorini::solid {

/// Strains of one Gauss point by the element's functions: δF_entry = Σ_A δu_iA row_A for the rows r of component i.
template <int D> struct StrainRows {
  int functions;
  const double *gradients, *hoop; ///< hoop is null in plane strain and 3D
  /// ∂R_A/∂X_k for F_ik, and R_A/R of the radial displacement for the hoop stretch.
  int count(int i) const { return D + (hoop && i == 0 ? 1 : 0); }
  const double* row(int r) const { return r < D ? gradients + r * functions : hoop; }
};

} // namespace signorini::solid
