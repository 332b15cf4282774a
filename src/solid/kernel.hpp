#pragma once
// The element kernel over raw arrays: stress, current gradients and tangent blocks at all Gauss points of one element.
// Compiled once for any machine and once for those with AVX2, chosen at run time.

namespace signorini::solid {

/// All arrays belong to the caller; n functions, D components. Per Gauss point: D rows of n values.
struct KernelArguments {
  int functions, points;
  double lambda, mu;
  const double* local;     ///< displacements, D rows of n values
  const double* gradients; ///< ∂R_A/∂X_k per Gauss point
  const double* weights;   ///< per Gauss point
  const double* constant;  ///< Σ w μ ∇R_A·∇R_B, n×n
  double* force;           ///< f_iA, D rows of n values
  double* current;         ///< working space, g_iA per Gauss point
  double* factors;         ///< working space, two per Gauss point
  double* blocks;          ///< K^{ij}_{AB}, i ≤ j, n×n each; null: not wanted
};

/// Where an element is inverted: the Gauss point and its J; point −1 when it is not.
struct KernelResult {
  int point;
  double jacobian;
};

using Kernel = KernelResult (*)(const KernelArguments&);

/// The fastest kernel that this machine runs, for bodies in D dimensions and elements of n functions.
template <int D> Kernel element_kernel(int functions);

} // namespace signorini::solid
