#pragma once
// The element kernels compiled for wider vectors and fused multiply-add: AVX2, and AVX-512 in space, where elements
// have enough functions to benefit.

#include "solid/energy_program.hpp"
#include "solid/kernel.hpp"

namespace signorini::solid {

Kernel avx2_plane_kernel(int functions);
Kernel avx2_space_kernel();
Kernel avx512_space_kernel();

Kernel avx2_plane_moduli_kernel();
Kernel avx2_space_moduli_kernel();
Kernel avx512_space_moduli_kernel();

/// The response of an energy of invariants in D dimensions.
using EnergyResponse = void (*)(const EnergyProgram& program, const PointBlock& block);
template <int D> std::vector<EnergyResponse> energy_responses();
template <> std::vector<EnergyResponse> energy_responses<2>();
template <> std::vector<EnergyResponse> energy_responses<3>();
EnergyResponse avx2_plane_response();
EnergyResponse avx2_space_response();
EnergyResponse avx512_space_response();

} // namespace signorini::solid
