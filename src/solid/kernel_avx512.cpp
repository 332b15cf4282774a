// Compiled with -mavx512f -mfma on x86-64 (src/CMakeLists.txt).
#include "solid/kernel_space.hpp"
#include "solid/kernel_wide.hpp"

namespace signorini::solid {

Kernel avx512_space_kernel() {
  return run_space;
}

} // namespace signorini::solid
