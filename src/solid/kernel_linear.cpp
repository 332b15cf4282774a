#include "solid/kernel.hpp"

#include <algorithm>

namespace signorini::solid {

template <int D> KernelResult linear_kernel(const KernelArguments& in) {
  const int n = in.functions;
  std::fill_n(in.force, D * n, 0.0);
  const double* k = in.constant;
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j)
      for (int a = 0; a < n; ++a, k += n) {
        // K^{ji} = (K^{ij})ᵀ
        double sum = 0;
        for (int b = 0; b < n; ++b) sum += k[b] * in.local[j * n + b];
        in.force[i * n + a] += sum;
        if (i != j)
          for (int b = 0; b < n; ++b) in.force[j * n + b] += k[b] * in.local[i * n + a];
      }
  if (in.blocks) std::copy(in.constant, k, in.blocks);
  return {-1, 1};
}

template KernelResult linear_kernel<2>(const KernelArguments&);
template KernelResult linear_kernel<3>(const KernelArguments&);

} // namespace signorini::solid
