#include "bind/threads.hpp"

#include "base/parallel.hpp"
#include "solid/kernel.hpp"

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>

namespace signorini::bind {

namespace {

/// A function of whichever library is loaded, or nullptr: BLAS is a choice of the machine's owner, so nothing of one
/// particular BLAS is linked.
template <class F> F* loaded(const char* name) {
  return reinterpret_cast<F*>(dlsym(RTLD_DEFAULT, name));
}

} // namespace

void set_threads(int threads) {
  set_worker_threads(threads);
  for (const char* variable : {"OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"}) setenv(variable, "1", 1);
  for (const char* name : {"openblas_set_num_threads", "omp_set_num_threads"})
    if (auto* set = loaded<void(int)>(name)) set(1);
  constexpr int threads_of_its_own = 1; // neither sequential (0) nor OpenMP (2)
  auto* kind = loaded<int()>("openblas_get_parallel");
  auto* shut_down = loaded<int()>("blas_thread_shutdown_");
  if (kind && shut_down && kind() == threads_of_its_own) shut_down();
}

std::string kernel_description() {
  return solid::instruction_names[static_cast<int>(solid::widest_instructions())];
}

std::string blas_description() {
  void* dgemm = dlsym(RTLD_DEFAULT, "dgemm_");
  Dl_info info;
  if (!dgemm || !dladdr(dgemm, &info)) return "none loaded";
  const std::string file = std::filesystem::weakly_canonical(info.dli_fname).string();
  auto* config = loaded<char*()>("openblas_get_config");
  return (config ? std::string(config()) + ", " : "") + file;
}

} // namespace signorini::bind
