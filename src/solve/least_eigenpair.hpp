#pragma once
// The lowest eigenvalue of a small dense symmetric matrix.

#include "base/eigen.hpp"

namespace signorini::solve {

struct Eigenpair {
  double value;
  VectorX vector;
};

/// The eigenvector has length 1; value and vector are 0 if LAPACK does not converge.
Eigenpair least_eigenpair(MatrixX symmetric);

} // namespace signorini::solve
