#pragma once
// The element kernels on raw arrays: force and tangent blocks of one element. They are compiled once for any machine
// and again for wider vectors, chosen at run time. Any law can use those of moduli_kernels(); neo-Hooke has its own.

#include "solid/response.hpp"

#include <cstddef>
#include <vector>

namespace signorini::solid {

/// Number of doubles that kernels may read or write beyond the end of gradients, constant, blocks and work: the widest
/// vector.
constexpr std::size_t vector_padding = 8;

/// All arrays belong to the caller; n functions, D components. Per Gauss point: D rows of n values.
struct KernelArguments {
  int functions, points;
  double lambda, mu;
  const double* local = nullptr;     ///< displacements, D rows of n values
  const double* gradients = nullptr; ///< ∂R_A/∂X_k per Gauss point
  const double* weights = nullptr;   ///< per Gauss point
  const double* hoop = nullptr;      ///< R_A/R per Gauss point, n values each; null unless it is a body of revolution
  const double* constant = nullptr;  ///< constant part of the tangent, see Kernels
  double* force = nullptr;           ///< f_iA, D rows of n values
  double* work = nullptr;            ///< work array, working_size() doubles
  double* factors = nullptr;         ///< work array, two per Gauss point
  double* blocks = nullptr;          ///< K^{ij}_{AB}, i ≤ j, n×n each; null: no tangent
  const void* law = nullptr;         ///< for `respond`
  Respond respond = nullptr;         ///< see Kernels
  bool small_strains = false;        ///< elements cannot be inverted
  PointMemory memory = {};           ///< of its Gauss points
  const double* predicted = nullptr; ///< per Gauss point, see predicted_volume.hpp; null: zeros
};

/// Size of the work array for D components, n functions and a number of Gauss points: displacements, forces and the
/// current gradients of all points in rows of whole vectors, and the factors of a tile of the tangent.
constexpr std::size_t working_size(std::size_t components, std::size_t functions, std::size_t points) {
  return components * (functions + vector_padding) * (points + 2) + 2 * vector_padding * points + 2 * vector_padding;
}

/// Size of the work array for laws that give stress and moduli at many points at once.
constexpr std::size_t moduli_working_size(std::size_t components, std::size_t functions, std::size_t points) {
  const std::size_t entries = static_cast<std::size_t>(entries_in(static_cast<int>(components)));
  return (2 * entries + entries * (entries + 1) / 2) * (points + vector_padding) +
         3 * (functions + vector_padding) * (points + 2) + 12 * points;
}

/// First Gauss point at which an element is inverted, and its J; point −1 if none.
struct KernelResult {
  int point;
  double jacobian;
};

using Kernel = KernelResult (*)(const KernelArguments&);

/// Meaning of a plane body. Bodies in 3D have only the first.
enum class Kind {
  plane_strain,
  axisymmetric, ///< x = r, y = z; the body fills the full circle around the axis x = 0
  plane_stress, ///< per unit of the undeformed thickness
};

/// The volume change is that of each point, or projected (projection.hpp).
enum class Volumetric { pointwise, projected };

/// Computation of the elements of a material.
struct Kernels {
  Kernel element;
  Kernel constant;           ///< null, or writes to zeroed `blocks`, for zero `local`, what `element` reads as constant
  int constant_blocks;       ///< number of n×n blocks of `constant`
  Respond respond = nullptr; ///< for an element kernel of moduli_kernels()
};

/// Vector instructions, from narrow to wide; baseline: those that every processor of the architecture has.
enum class Instructions { baseline, avx2, avx512 };
#ifdef __x86_64__
constexpr const char* instruction_names[] = {"sse2", "avx2", "avx512"};
#else
constexpr const char* instruction_names[] = {"plain", "avx2", "avx512"};
#endif

/// The widest instructions that kernels may use: those of this processor, or of the environment variable
/// SIGNORINI_KERNEL if it is set.
Instructions widest_instructions();
/// Likewise for a value of the variable; nullptr: not set.
Instructions widest_instructions(const char* wanted);

/// The neo-Hooke kernels up to the widest instructions, for bodies in D dimensions and elements of n functions; the
/// last is the fastest. Their results differ by rounding error.
template <int D> std::vector<Kernel> element_kernels(int functions);

/// The kernels for laws that give stress and moduli at many points at once, up to the widest instructions. The Jacobian
/// of an inverted element is det F of a solid, and in the plane that of the plane part or, if a point of a body of
/// revolution crossed the axis, the hoop stretch r/R: whichever is not positive.
template <int D> std::vector<Kernel> moduli_kernels();
template <> std::vector<Kernel> moduli_kernels<2>();
template <> std::vector<Kernel> moduli_kernels<3>();

/// Neo-Hooke for bodies of revolution without twist, x = r, y = z: `hoop` must not be null, and the weights include the
/// circumference 2πR. The Jacobian of an inverted element is that of moduli_kernels().
KernelResult axisymmetric_kernel(const KernelArguments& arguments);

} // namespace signorini::solid
