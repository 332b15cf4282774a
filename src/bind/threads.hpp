#pragma once
// How many threads the libraries below use, and which BLAS that is.

#include <string>

namespace signorini::bind {

/// Sets the threads of BLAS and OpenMP, here and for child processes.
void set_threads(int threads);

/// "OpenBLAS 0.3.21 …, libopenblas.so" of the BLAS that is loaded.
std::string blas_description();

} // namespace signorini::bind
