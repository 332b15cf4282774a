#pragma once
// The face of direct solvers: analyze a pattern, factor one matrix after the other on it, solve.

#include "solve/values.hpp"

#include <functional>
#include <memory>

namespace signorini::solve {

/// What a solver has done since it was made.
struct SolverStatistics {
  int factorizations = 0; ///< numerical ones
  int solutions = 0;      ///< right-hand sides
  int iterations = 0;     ///< of GMRES, summed
  double operations = 0;  ///< floating-point, of one factorization; 0: not known
  double entries = 0;     ///< that one solution with the factors reads; 0: not known
  double memory = 0;      ///< bytes of the factors
};

/// Factors matrices on a structurally symmetric pattern. It owns what it keeps: pattern, values and right-hand side may
/// go when a call returns.
class DirectSolver {
public:
  virtual ~DirectSolver() = default;
  /// Takes the pattern of the matrices to come, and drops earlier factors.
  virtual void analyze(const Pattern& pattern) = 0;
  /// Factors the matrix with these values, in the order of the pattern. Returns false when it is singular to working
  /// precision; the next matrix may be regular.
  virtual bool factor(const double* values) = 0;
  /// Overwrites b by K⁻¹ b; call after a successful factor(), for as many right-hand sides as there are. Returns false
  /// when the matrix turns out to be singular to working precision.
  virtual bool solve(double* b) = 0;
  /// Of the last factorization.
  virtual PivotRange pivots() const = 0;
  virtual SolverStatistics statistics() const = 0;
};

using MakeDirect = std::function<std::unique_ptr<DirectSolver>()>;

/// KLU, for small matrices of any kind: LU with the pivots of the last full factorization as long as they serve. The
/// statistics tell the operations that analyze() expects before the first factorization.
std::unique_ptr<DirectSolver> make_klu();
/// UMFPACK, for matrices of any kind: multifrontal LU with threshold pivots, ordered by nested dissection (METIS).
std::unique_ptr<DirectSolver> make_umfpack();

} // namespace signorini::solve
