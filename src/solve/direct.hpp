#pragma once
// The interface of direct solvers: analyze a pattern, factor matrices with it, solve.

#include "solve/values.hpp"

#include <functional>
#include <memory>

namespace signorini::solve {

/// Counters of a solver since its construction.
struct SolverStatistics {
  int factorizations = 0; ///< numerical factorizations
  int solutions = 0;      ///< right-hand sides
  int iterations = 0;     ///< of GMRES, total
  double operations = 0;  ///< floating-point operations of one factorization; 0: unknown
  double entries = 0;     ///< entries of the factors that one solution reads; 0: unknown
  double memory = 0;      ///< bytes of the factors
  double rank_memory = 0; ///< bytes that the MPI process with the most used; 0: unknown
  int negative = -1;      ///< negative pivots of the last symmetric matrix; −1: unknown
  /// True if the pivots of the last matrix are positive, and on its diagonal: a symmetric one is positive definite.
  bool definite = false;
};

/// Factors matrices with a structurally symmetric pattern. It copies what it needs: pattern, values and right-hand side
/// may be destroyed after each call.
class DirectSolver {
public:
  virtual ~DirectSolver() = default;
  /// Sets the pattern of the matrices that follow, and drops earlier factors.
  virtual void analyze(const Pattern& pattern) = 0;
  /// Factors the matrix with these values, in the order of the pattern. Returns false if it is singular to working
  /// precision; the next matrix may be regular.
  virtual bool factor(const double* values) = 0;
  /// Overwrites b by K⁻¹ b; call after a successful factor(), for any number of right-hand sides. Returns false if the
  /// matrix turns out to be singular to working precision.
  virtual bool solve(double* b) = 0;
  /// Pivots of the last factorization.
  virtual PivotRange pivots() const = 0;
  virtual SolverStatistics statistics() const = 0;
};

using MakeDirect = std::function<std::unique_ptr<DirectSolver>()>;

/// KLU, for small matrices of any kind: LU with the pivots of the last full factorization as long as they are accurate.
/// The statistics contain the operations estimated by analyze() before the first factorization.
std::unique_ptr<DirectSolver> make_klu();
/// UMFPACK, for matrices of any kind: multifrontal LU with threshold pivoting, ordered by nested dissection (METIS).
std::unique_ptr<DirectSolver> make_umfpack();

} // namespace signorini::solve
