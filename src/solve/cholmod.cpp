#include "solve/cholmod.hpp"

#include <dlfcn.h>

namespace signorini::solve {

namespace {

/// A function of the OpenMP library that CHOLMOD has loaded, or nullptr if it was built without.
template <class F> F* openmp(const char* name) {
  return reinterpret_cast<F*>(dlsym(RTLD_DEFAULT, name));
}

} // namespace

void factorize(cholmod_sparse& matrix, cholmod_factor* factor, cholmod_common& common) {
  static auto* const depth = openmp<int()>("omp_get_max_active_levels");
  static auto* const set_depth = openmp<void(int)>("omp_set_max_active_levels");
  const int before = depth ? depth() : 0;
  if (depth && set_depth) set_depth(0);
  cholmod_factorize(&matrix, factor, &common);
  if (depth && set_depth) set_depth(before);
}

} // namespace signorini::solve
