#pragma once
// Owners of CHOLMOD's objects (Chen, Davis, Hager, Rajamanickam, ACM TOMS 35, 2008), for the solvers based on it.

#include "solve/direct.hpp"

#include <cholmod.h>

#include <memory>

namespace signorini::solve {

/// Settings, statistics and workspace. Prints nothing: errors are read from `status`.
struct CholmodCommon : cholmod_common {
  CholmodCommon() : cholmod_common{} {
    cholmod_start(this);
    print = 0;
  }
  ~CholmodCommon() { cholmod_finish(this); }
  CholmodCommon(const CholmodCommon&) = delete;
  CholmodCommon& operator=(const CholmodCommon&) = delete;
};

/// A factor, freed with the common that it was created with.
struct CholmodFactor {
  cholmod_factor* factor = nullptr;
  cholmod_common* common;
  explicit CholmodFactor(cholmod_common& owner) : common(&owner) {}
  ~CholmodFactor() { cholmod_free_factor(&factor, common); }
  CholmodFactor(const CholmodFactor&) = delete;
  CholmodFactor& operator=(const CholmodFactor&) = delete;
};

/// The lower triangle of a symmetric matrix that is stored in full; nothing is copied, so pattern and values must
/// persist.
inline cholmod_sparse lower_triangle(const Pattern& pattern, const double* values) {
  cholmod_sparse matrix{};
  matrix.nrow = matrix.ncol = static_cast<std::size_t>(pattern.size);
  matrix.nzmax = pattern.rows.size();
  matrix.p = const_cast<int*>(pattern.starts.data()); // CHOLMOD only reads them
  matrix.i = const_cast<int*>(pattern.rows.data());
  matrix.x = const_cast<double*>(values);
  matrix.stype = -1;
  matrix.itype = CHOLMOD_INT;
  matrix.xtype = CHOLMOD_REAL;
  matrix.dtype = CHOLMOD_DOUBLE;
  matrix.sorted = matrix.packed = 1;
  return matrix;
}

/// The right-hand sides and workspace of triangular solves, allocated by the first solve and reused.
class CholmodSolve {
public:
  explicit CholmodSolve(cholmod_common& common) : common_(common) {}
  ~CholmodSolve() {
    for (cholmod_dense** matrix : {&result_, &first_, &second_}) cholmod_free_dense(matrix, &common_);
  }
  CholmodSolve(const CholmodSolve&) = delete;
  CholmodSolve& operator=(const CholmodSolve&) = delete;

  /// The solution of the `system` (CHOLMOD_A, CHOLMOD_L, …) for the right-hand side b; nullptr if it failed. Valid
  /// until the next call.
  double* operator()(int system, cholmod_factor* factor, double* b) {
    cholmod_dense right{};
    right.nrow = right.nzmax = right.d = factor->n;
    right.ncol = 1;
    right.x = b;
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    const bool solved = cholmod_solve2(system, factor, &right, nullptr, &result_, nullptr, &first_, &second_, &common_);
    return solved ? static_cast<double*>(result_->x) : nullptr;
  }

private:
  cholmod_common& common_;
  cholmod_dense *result_ = nullptr, *first_ = nullptr, *second_ = nullptr;
};

} // namespace signorini::solve
