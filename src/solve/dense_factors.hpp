#pragma once
// LU of dense matrices, on all worker threads.

#include "base/eigen.hpp"

#include <vector>

namespace signorini::solve {

template <class Real> using DenseMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// Overwrites a square A by its factors, P A = L U with row pivoting; `exchanges` are P in LAPACK's numbering. Returns
/// false if U is singular. Results are bitwise identical for any number of threads.
template <class Real> bool factor_dense(DenseMatrix<Real>& a, std::vector<int>& exchanges);

/// Overwrites b by A⁻¹ b.
template <class Real>
void solve_dense(const DenseMatrix<Real>& factors, const std::vector<int>& exchanges, Eigen::Ref<VectorX> b);

/// True if the symmetric part of a square A is positive definite.
bool is_positive_definite(DenseMatrix<double> a);

} // namespace signorini::solve
