// Compiled with -mavx512f -mfma on x86-64 (src/CMakeLists.txt).
#include "solid/energy_response.hpp"
#include "solid/kernel_moduli.hpp"
#include "solid/kernel_wide.hpp"

namespace signorini::solid {

Kernel avx512_space_kernel() {
  return run_space;
}

Kernel avx512_space_moduli_kernel() {
  return run_moduli<3>;
}

EnergyResponse avx512_space_response() {
  return respond_by_energy<9>;
}

} // namespace signorini::solid
