// Compiled with -mavx512f -mfma on x86-64 (src/CMakeLists.txt).
#include "solid/kernel_space.hpp"
#include "solid/kernel_wide.hpp"

namespace signorini::solid {

bool runs_avx512() {
#ifdef __AVX512F__
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}

Kernel avx512_space_kernel() {
  return run_space;
}

} // namespace signorini::solid
