#pragma once
// The element kernels over raw arrays: force and tangent blocks of one element. Any law has the generic one
// (kernel_generic.hpp). Those for neo-Hooke in the plane and in space are compiled once for any machine and again for
// those with wider vectors, chosen at run time.

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
  const double* local = nullptr;     ///< displacements, D rows of n values
  const double* gradients = nullptr; ///< ∂R_A/∂X_k per Gauss point
  const double* weights = nullptr;   ///< per Gauss point
  const double* hoop = nullptr;      ///< R_A/R per Gauss point, n values each; null unless it is a body of revolution
  const double* constant = nullptr;  ///< the part of the tangent that never changes, see Kernels
  double* force = nullptr;           ///< f_iA, D rows of n values
  double* work = nullptr;            ///< working space, working_size() doubles
  double* factors = nullptr;         ///< working space, two per Gauss point
  double* blocks = nullptr;          ///< K^{ij}_{AB}, i ≤ j, n×n each; null: not wanted
  const void* law = nullptr;         ///< for the generic kernel
  int internal_variables = 0;        ///< per Gauss point
  const double* committed = nullptr; ///< their values at the step's start
  double* trial = nullptr;           ///< receives their present values
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

/// What a plane body stands for. In 3D there is only the first.
enum class Kind {
  plane_strain,
  axisymmetric, ///< x = r, y = z; the body fills the full circle around the axis x = 0
};

/// How elements of a material are computed.
struct Kernels {
  Kernel element;
  Kernel constant; ///< null, or puts into zeroed `blocks`, once and for zero `local`, what `element` reads as constant
  int constant_blocks; ///< how many n×n blocks that is
};

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

/// Neo-Hooke for bodies of revolution that deform without twist, x = r, y = z: `hoop` must not be null, and the weights
/// hold the circumference 2πR. Where the element is inverted the Jacobian is as in generic_kernel().
KernelResult axisymmetric_kernel(const KernelArguments& arguments);

} // namespace signorini::solid
