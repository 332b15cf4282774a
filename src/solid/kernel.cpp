#include "solid/kernel.hpp"

#include "solid/kernel_plane.hpp"
#include "solid/kernel_space.hpp"
#include "solid/kernel_wide.hpp"

namespace signorini::solid {

template <> std::vector<Kernel> element_kernels<2>(int functions) {
  std::vector<Kernel> kernels{plane_kernel(functions)};
  if (runs_avx2()) kernels.push_back(avx2_plane_kernel(functions));
  return kernels;
}

template <> std::vector<Kernel> element_kernels<3>(int) {
  std::vector<Kernel> kernels{run_space};
  if (runs_avx2()) kernels.push_back(avx2_space_kernel());
  if (runs_avx512()) kernels.push_back(avx512_space_kernel());
  return kernels;
}

} // namespace signorini::solid
