#include "solid/kernel.hpp"

#include "solid/kernel_avx2.hpp"
#include "solid/kernel_loops.hpp"

namespace signorini::solid {

template <int D> Kernel element_kernel(int functions) {
  static const bool wide = avx2_kernels_run_here();
  return wide ? avx2_kernel<D>(functions) : select<D>(functions);
}

template Kernel element_kernel<2>(int);
template Kernel element_kernel<3>(int);

} // namespace signorini::solid
