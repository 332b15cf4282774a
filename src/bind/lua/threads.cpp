#include "bind/lua/threads.hpp"

#include "os/parallel.hpp"

#include <cstdlib>

namespace signorini::bind {

void set_threads(int threads) {
  set_worker_threads(threads);
  for (const char* variable : {"OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"}) setenv(variable, "1", 1);
  for (const char* name : {"openblas_set_num_threads", "omp_set_num_threads"})
    if (auto* set = loaded<void(int)>(name)) set(1);
  constexpr int threads_of_its_own = 1; // own threads, neither sequential (0) nor OpenMP (2)
  auto* kind = loaded<int()>("openblas_get_parallel");
  auto* shut_down = loaded<int()>("blas_thread_shutdown_");
  if (kind && shut_down && kind() == threads_of_its_own) shut_down();
}

} // namespace signorini::bind
