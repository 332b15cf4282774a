#pragma once
// The element kernels over raw arrays: force and tangent blocks of one element. The one for neo-Hooke in the plane and
// in space is compiled once for any machine and once for those with AVX2, chosen at run time; bodies of revolution and
// small strains have kernels of their own (axisymmetric.hpp, linear.hpp).

namespace signorini::solid {

/// All arrays belong to the caller; n functions, D components. Per Gauss point: D rows of n values.
struct KernelArguments {
  int functions, points;
  double lambda, mu;
  const double* local;     ///< displacements, D rows of n values
  const double* gradients; ///< ∂R_A/∂X_k per Gauss point
  const double* weights;   ///< per Gauss point
  const double* hoop;      ///< R_A/R per Gauss point, n values each; null where the body is none of revolution
  const double* constant;  ///< Σ w μ ∇R_A·∇R_B, n×n; small strains: the stiffness, laid out like `blocks`
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

/// The fastest neo-Hooke kernel that this machine runs, for bodies in D dimensions and elements of n functions.
template <int D> Kernel element_kernel(int functions);

} // namespace signorini::solid
