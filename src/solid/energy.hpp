#pragma once
// A compiled energy, and its derivatives with respect to F if it is one of the principal stretches.

#include "solid/hyperelastic.hpp"
#include "solid/kernel_wide.hpp"
#include "symbolic/tape.hpp"

namespace signorini::solid {

struct Energy {
  EnergyFormula formula;
  symbolic::Tape value;       ///< W
  symbolic::Tape derivatives; ///< ∂W/∂x_v, then ∂²W/∂x_v∂x_w for v ≤ w, row by row
  int variables;
  EnergyProgram program;     ///< of an energy of invariants; points into `derivatives` and `formula`
  EnergyResponse respond[2]; ///< its responses in 2 and 3 dimensions
};

/// The principal stretches, ascending.
std::vector<double> stretches_of(const Mat<3>& f);
/// The response of an energy of the stretches in D dimensions.
template <int D> void respond_by_stretches(const Energy& energy, const PointBlock& block);

/// The moduli of symmetric strains, whose components are ε₁₁, ε₂₂, ε₃₃, √2 ε₂₃, √2 ε₁₃, √2 ε₁₂.
Mat<6> strain_moduli(const Moduli& moduli);

} // namespace signorini::solid
