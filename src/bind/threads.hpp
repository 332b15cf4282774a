#pragma once
// How many threads and which kernels the program uses, and which BLAS that is.

#include <string>

namespace signorini::bind {

/// More of them are a slip of the pen, and may be more than the system starts.
inline constexpr int most_threads = 1024;

/// Sets the threads of assembly. BLAS stays on one: waiting threads of OpenBLAS spin, which on a busy machine takes
/// more time from triangular solves than two threads save. The pool that OpenBLAS starts when it is loaded ends here.
void set_threads(int threads);

/// The widest vector instructions of the element kernels, such as "avx2"; an error where SIGNORINI_KERNEL names others
/// than this machine has.
std::string kernel_description();

/// "OpenBLAS 0.3.21 …, libopenblas.so" of the BLAS that is loaded.
std::string blas_description();

} // namespace signorini::bind
