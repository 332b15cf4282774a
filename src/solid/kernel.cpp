#include "solid/kernel.hpp"

#include "solid/energy_response.hpp"
#include "solid/kernel_moduli.hpp"
#include "solid/kernel_wide.hpp"

#include "base/error.hpp"

#include <cstdlib>
#include <string_view>

namespace signorini::solid {

namespace {

Instructions widest_of_processor() {
#ifdef __x86_64__
  const bool fma = __builtin_cpu_supports("fma");
  if (fma && __builtin_cpu_supports("avx512f")) return Instructions::avx512;
  if (fma && __builtin_cpu_supports("avx2")) return Instructions::avx2;
#endif
  return Instructions::baseline;
}

} // namespace

Instructions widest_instructions(const char* wanted) {
  const Instructions widest = widest_of_processor();
  if (!wanted || !*wanted) return widest;
  for (Instructions known : {Instructions::baseline, Instructions::avx2, Instructions::avx512}) {
    const char* name = instruction_names[static_cast<int>(known)];
    if (std::string_view(name) != wanted) continue;
    require(known <= widest, "solid.kernel.lacking",
            {{"name", name}, {"widest", instruction_names[static_cast<int>(widest)]}});
    return known;
  }
  fail("solid.kernel.unknown", {{"name", wanted}, {"baseline", instruction_names[0]}});
}

Instructions widest_instructions() {
  static const Instructions widest = widest_instructions(std::getenv("SIGNORINI_KERNEL"));
  return widest;
}

template <> std::vector<Kernel> element_kernels<2>(int functions) {
  std::vector<Kernel> kernels{plane_kernel(functions)};
  if (widest_instructions() >= Instructions::avx2) kernels.push_back(avx2_plane_kernel(functions));
  return kernels;
}

template <> std::vector<Kernel> element_kernels<3>(int) {
  std::vector<Kernel> kernels{run_space};
  if (widest_instructions() >= Instructions::avx2) kernels.push_back(avx2_space_kernel());
  if (widest_instructions() >= Instructions::avx512) kernels.push_back(avx512_space_kernel());
  return kernels;
}

template <> std::vector<Kernel> moduli_kernels<2>() {
  std::vector<Kernel> kernels{run_moduli<2>};
  if (widest_instructions() >= Instructions::avx2) kernels.push_back(avx2_plane_moduli_kernel());
  return kernels;
}

template <> std::vector<Kernel> moduli_kernels<3>() {
  std::vector<Kernel> kernels{run_moduli<3>};
  if (widest_instructions() >= Instructions::avx2) kernels.push_back(avx2_space_moduli_kernel());
  if (widest_instructions() >= Instructions::avx512) kernels.push_back(avx512_space_moduli_kernel());
  return kernels;
}

template <> std::vector<EnergyResponse> energy_responses<2>() {
  std::vector<EnergyResponse> responses{respond_by_energy<5>};
  if (widest_instructions() >= Instructions::avx2) responses.push_back(avx2_plane_response());
  return responses;
}

template <> std::vector<EnergyResponse> energy_responses<3>() {
  std::vector<EnergyResponse> responses{respond_by_energy<9>};
  if (widest_instructions() >= Instructions::avx2) responses.push_back(avx2_space_response());
  if (widest_instructions() >= Instructions::avx512) responses.push_back(avx512_space_response());
  return responses;
}

} // namespace signorini::solid
