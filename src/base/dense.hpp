#pragma once
// Dense decompositions for where their speed does not matter. They are compiled once: each of Eigen's, for each type of
// matrix, takes seconds to compile.

#include "base/eigen.hpp"

namespace signorini::dense {

/// X with A X = B by LU with partial pivoting; A: n × n, B: n × m. Not finite if A is singular.
MatrixX solve(const MatrixX& a, const MatrixX& b);
/// The X of least norm among those with the least ‖A X − B‖; A: n × k of any rank, B: n × m.
MatrixX least_squares(const MatrixX& a, const MatrixX& b);
/// L with L Lᵀ = A, for a symmetric positive definite A.
MatrixX cholesky(const MatrixX& a);
/// The orthogonal Q of A = Q R; A: n × n.
MatrixX orthogonal(const MatrixX& a);
/// Eigenvalues of a symmetric A, ascending.
VectorX symmetric_eigenvalues(const MatrixX& a);

/// A = U diag(values) Vᵀ, values descending; A: m × n, U: m × k, V: n × k, k the smaller of m and n.
struct SingularValues {
  MatrixX u;
  VectorX values;
  MatrixX v;
};
SingularValues singular_values(const MatrixX& a);

} // namespace signorini::dense
