// Compiled with -mavx2 -mfma on x86-64 (src/CMakeLists.txt).
#include "solid/energy_response.hpp"
#include "solid/kernel_moduli.hpp"
#include "solid/kernel_wide.hpp"

namespace signorini::solid {

Kernel avx2_plane_kernel(int functions) {
  return plane_kernel(functions);
}

Kernel avx2_space_kernel() {
  return run_space;
}

Kernel avx2_plane_moduli_kernel() {
  return run_moduli<2>;
}

Kernel avx2_space_moduli_kernel() {
  return run_moduli<3>;
}

EnergyResponse avx2_plane_response() {
  return respond_by_energy<5>;
}

EnergyResponse avx2_space_response() {
  return respond_by_energy<9>;
}

} // namespace signorini::solid
