#pragma once
// The element kernel compiled for machines with AVX2 and fused multiply-add.

#include "solid/kernel.hpp"

namespace signorini::solid {

/// Whether this machine has the instructions; false where the program was built for another architecture.
bool avx2_kernels_run_here();
template <int D> Kernel avx2_kernel(int functions);

} // namespace signorini::solid
