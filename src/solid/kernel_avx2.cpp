// Compiled with -mavx2 -mfma on x86-64 (src/CMakeLists.txt).
#include "solid/kernel_plane.hpp"
#include "solid/kernel_space.hpp"
#include "solid/kernel_wide.hpp"

namespace signorini::solid {

Kernel avx2_plane_kernel(int functions) {
  return plane_kernel(functions);
}

Kernel avx2_space_kernel() {
  return run_space;
}

} // namespace signorini::solid
