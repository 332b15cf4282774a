#pragma once
// Orthonormal columns and least squares for few columns, compiled once: Eigen's own factorizations take the compiler
// half a minute in every file that uses them.

#include "base/eigen.hpp"

namespace signorini {

/// Q of X = Q R, by Gram-Schmidt with reorthogonalization; a column of zeros remains.
MatrixX orthonormal(MatrixX x);

/// The pseudo-inverse of a matrix of independent columns.
MatrixX pseudo_inverse(const MatrixX& x);

/// B − Q Qᵀ B: what least squares over orthonormal columns Q leave of each column.
MatrixX residual_of(const MatrixX& q, MatrixX b);

} // namespace signorini
