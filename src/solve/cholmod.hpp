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

/// The upper triangle, which CHOLMOD permutes with one transposition less than the lower one, of a symmetric matrix
/// that is stored in full; nothing is copied, so pattern and values must persist.
inline cholmod_sparse upper_triangle(const Pattern& pattern, const double* values) {
  cholmod_sparse matrix{};
  matrix.nrow = matrix.ncol = static_cast<std::size_t>(pattern.size);
  matrix.nzmax = pattern.rows.size();
  matrix.p = const_cast<int*>(pattern.starts.data()); // CHOLMOD only reads them
  matrix.i = const_cast<int*>(pattern.rows.data());
  matrix.x = const_cast<double*>(values);
  matrix.stype = 1;
  matrix.itype = CHOLMOD_INT;
  matrix.xtype = CHOLMOD_REAL;
  matrix.dtype = CHOLMOD_DOUBLE;
  matrix.sorted = matrix.packed = 1;
  return matrix;
}

/// Factors without CHOLMOD's own threads: it requests four from OpenMP, whatever the user or the machine has, for loops
/// far shorter than the start of a thread. BLAS keeps its threads.
void factorize(cholmod_sparse& matrix, cholmod_factor* factor, cholmod_common& common);

} // namespace signorini::solve
