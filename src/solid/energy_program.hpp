#pragma once
// An energy of invariants, compiled: plain data for the files compiled for wider vectors.

#include "solid/response.hpp"
#include "symbolic/instruction.hpp"

namespace signorini::solid {

constexpr int most_fibers = 4;
constexpr int most_invariants = 3 + most_fibers; ///< I₁, I₂, J, then |F a|² for each fiber direction a

struct EnergyProgram {
  const symbolic::Instruction* code;
  int registers, invariants;
  int slopes_end, curvatures_end;                   ///< numbers of instructions for the first, and for all derivatives
  const double* fibers;                             ///< three components per direction, of length 1
  int slopes[most_invariants];                      ///< registers of ∂W/∂I_v; −1: zero
  int curvatures[most_invariants][most_invariants]; ///< registers of ∂²W/∂I_v∂I_w; −1: zero
};

} // namespace signorini::solid
