#pragma once
// The element kernels compiled for wider vectors and fused multiply-add: AVX2, and AVX-512 in space, where elements
// have enough functions to benefit.

#include "solid/kernel.hpp"

namespace signorini::solid {

Kernel avx2_plane_kernel(int functions);
Kernel avx2_space_kernel();
Kernel avx512_space_kernel();

} // namespace signorini::solid
