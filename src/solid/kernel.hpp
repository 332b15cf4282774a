#pragma once
// The element kernels over raw arrays: force and tangent blocks of one element. Those for neo-Hooke in the plane and in
// space are compiled once for any machine and again for those with wider vectors, chosen at run time; bodies of
// revolution and small strains have kernels of their own (axisymmetric.hpp, linear.hpp).

#include <cstddef>
#include <vector>

namespace signorini::solid {

/// Doubles that kernels may read, or write, beyond the end of gradients, constant, blocks and work: what the widest
/// vector reaches.
constexpr std::size_t vector_room = 8;

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
  double* work;            ///< working space, working_size() doubles
  double* factors;         ///< working space, two per Gauss point
  double* blocks;          ///< K^{ij}_{AB}, i ≤ j, n×n each; null: not wanted
};

/// Working space for D components, n functions and a number of Gauss points: displacements, forces and all points'
/// current gradients in rows of whole vectors, and the factors of a tile of the tangent.
constexpr std::size_t working_size(std::size_t components, std::size_t functions, std::size_t points) {
  return components * (functions + vector_room) * (points + 2) + 2 * vector_room * points + 2 * vector_room;
}

/// Where an element is inverted: the Gauss point and its J; point −1 when it is not.
struct KernelResult {
  int point;
  double jacobian;
};

using Kernel = KernelResult (*)(const KernelArguments&);

/// Vector instructions, from narrow to wide; sse2 stands for what every machine has.
enum class Instructions { sse2, avx2, avx512 };
constexpr const char* instruction_names[] = {"sse2", "avx2", "avx512"};

/// The widest instructions that kernels may use: those of this processor, or, where it is set, those that the
/// environment variable SIGNORINI_KERNEL names.
Instructions widest_instructions();
/// The same for a value of the variable, or nullptr where it is not set.
Instructions widest_instructions(const char* wanted);

/// The neo-Hooke kernels up to the widest instructions, for bodies in D dimensions and elements of n functions; the
/// fastest is the last. They differ by rounding error.
template <int D> std::vector<Kernel> element_kernels(int functions);

} // namespace signorini::solid
