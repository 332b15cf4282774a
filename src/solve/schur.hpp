#pragma once
// Factorizations of symmetric matrices that stop before some of the unknowns.

#include "base/eigen.hpp"
#include "solve/direct.hpp"

namespace signorini::solve {

/// With the border c behind the interior i of all other unknowns, eliminates the interior of a symmetric A and leaves
///     S = A_cc − A_ci A_ii⁻¹ A_ic.
/// It owns what it keeps.
class SchurSolver {
public:
  virtual ~SchurSolver() = default;
  /// Takes the pattern of the matrices to come, and the unknowns of the border. statistics().operations may tell what
  /// a factorization will take.
  virtual void analyze(const Pattern& pattern, const std::vector<int>& border) = 0;
  /// Factors the matrix with these values, in the order of the pattern. Returns false when A_ii is singular to working
  /// precision, or has negative eigenvalues that the solver cannot cope with.
  virtual bool factor(const double* values) = 0;
  /// The border in the order of the rows of S.
  virtual const std::vector<int>& border() const = 0;
  /// S of the last factorization.
  virtual const MatrixX& complement() const = 0;
  /// x_i = A_ii⁻¹ (b_i − A_ic x_c) in place of b, with the x_c that `middle` puts in place of b_c − A_ci A_ii⁻¹ b_i.
  virtual bool solve(double* b, const std::function<bool(double*)>& middle) = 0;
  /// Of A_ii.
  virtual PivotRange pivots() const = 0;
  virtual SolverStatistics statistics() const = 0;
};

/// By any direct solver of A_ii: one solution for each unknown of the border, and two for each system.
std::unique_ptr<SchurSolver> make_schur(std::unique_ptr<DirectSolver> interior);

/// By CHOLMOD, which needs a positive definite A_ii: all of L is found at once, the border's part by dense blocks.
/// Minimum degree orders the interior, nested dissection (METIS) where that leaves more than `dissect_above` operations
/// for each entry of L.
std::unique_ptr<SchurSolver> make_schur_cholesky(double dissect_above);

} // namespace signorini::solve
