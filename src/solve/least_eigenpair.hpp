#pragma once
// The least eigenvalue of a small dense symmetric matrix.

#include "base/eigen.hpp"

namespace signorini::solve {

struct Eigenpair {
  double value;
  VectorX vector;
};

/// The vector has length 1; it is 0 with the value where LAPACK does not converge.
Eigenpair least_eigenpair(MatrixX symmetric);

} // namespace signorini::solve
