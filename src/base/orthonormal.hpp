#pragma once
// Orthonormal columns and least squares for few columns, compiled once: Eigen's factorizations add half a minute of
// compile time to every file that uses them.

#include "base/eigen.hpp"

namespace signorini {

/// Q of X = Q R, by Gram–Schmidt with reorthogonalization; a zero column stays zero.
MatrixX orthonormal(MatrixX x);

/// The pseudo-inverse of a matrix with independent columns.
MatrixX pseudo_inverse(const MatrixX& x);

/// B − Q Qᵀ B: the least-squares residual of each column for orthonormal columns Q.
MatrixX residual_of(const MatrixX& q, MatrixX b);

} // namespace signorini
