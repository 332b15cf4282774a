// Compiled with -mavx2 -mfma on x86-64 (src/CMakeLists.txt).
#include "solid/kernel_avx2.hpp"

#include "solid/kernel_loops.hpp"

namespace signorini::solid {

bool avx2_kernels_run_here() {
#ifdef __AVX2__
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}

template <int D> Kernel avx2_kernel(int functions) {
  return select<D>(functions);
}

template Kernel avx2_kernel<2>(int);
template Kernel avx2_kernel<3>(int);

} // namespace signorini::solid
