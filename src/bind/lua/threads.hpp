#pragma once
// Number of threads of the program, and functions of optional libraries.

#include <dlfcn.h>

namespace signorini::bind {

/// Larger numbers are probably typing errors, and may exceed the system's limit.
inline constexpr int most_threads = 1024;

/// Sets the threads of assembly. BLAS stays on one: waiting threads of OpenBLAS spin, which on a busy machine costs
/// triangular solves more time than two threads save. Ends the thread pool that OpenBLAS starts when loaded.
void set_threads(int threads);

/// A function of the loaded library, or nullptr: the administrator chooses the BLAS, so functions of a particular one
/// are not linked.
template <class F> F* loaded(const char* name) {
  return reinterpret_cast<F*>(dlsym(RTLD_DEFAULT, name));
}

} // namespace signorini::bind
