#pragma once
// How many threads the program uses, and functions of libraries that need not be there.

#include <dlfcn.h>

namespace signorini::bind {

/// More of them are a slip of the pen, and may be more than the system starts.
inline constexpr int most_threads = 1024;

/// Sets the threads of assembly. BLAS stays on one: waiting threads of OpenBLAS spin, which on a busy machine takes
/// more time from triangular solves than two threads save. The pool that OpenBLAS starts when it is loaded ends here.
void set_threads(int threads);

/// A function of whichever library is loaded, or nullptr: BLAS is a choice of the machine's owner, so nothing of one
/// particular BLAS is linked.
template <class F> F* loaded(const char* name) {
  return reinterpret_cast<F*>(dlsym(RTLD_DEFAULT, name));
}

} // namespace signorini::bind
