#pragma once
// Eigenvalues and eigenvectors of small dense matrices.

#include "base/eigen.hpp"

namespace signorini::solve {

struct Eigenpair {
  double value;
  VectorX vector;
};

/// That with the lowest value of a symmetric matrix. The eigenvector has length 1; value and vector are 0 if LAPACK
/// does not converge.
Eigenpair least_eigenpair(MatrixX symmetric);

/// One column per value, of length 1. Complex values come in pairs a + bi, a − bi, whose columns are the real and the
/// imaginary part of the eigenvector of the first. Empty if LAPACK does not converge.
struct Eigenpairs {
  Eigen::VectorXcd values;
  MatrixX vectors;
};

/// Increasing values and orthonormal vectors.
Eigenpairs symmetric_eigenpairs(MatrixX symmetric);
Eigenpairs eigenpairs(MatrixX matrix);

} // namespace signorini::solve
