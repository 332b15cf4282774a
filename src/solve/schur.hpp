#pragma once
// Partial factorization of symmetric matrices: the Schur complement of some unknowns.

#include "base/eigen.hpp"
#include "solve/direct.hpp"

namespace signorini::solve {

/// Eliminates the interior unknowns i of a symmetric A and leaves the Schur complement of the border c, which is
/// ordered last:
///     S = A_cc − A_ci A_ii⁻¹ A_ic [theory 10.5].
/// It copies what it needs.
class SchurSolver {
public:
  virtual ~SchurSolver() = default;
  /// Sets the pattern of the matrices that follow, and the unknowns of the border. Afterwards statistics().operations
  /// may contain an estimate for the factorization.
  virtual void analyze(const Pattern& pattern, const std::vector<int>& border) = 0;
  /// Factors the matrix with these values, in the order of the pattern. Returns false unless A_ii is positive definite
  /// and regular to working precision.
  virtual bool factor(const double* values) = 0;
  /// The border in the order of the rows of S.
  virtual const std::vector<int>& border() const = 0;
  /// S of the last factorization.
  virtual const MatrixX& complement() const = 0;
  /// Replaces b by the solution: `middle` replaces b_c − A_ci A_ii⁻¹ b_i by x_c, then x_i = A_ii⁻¹ (b_i − A_ic x_c).
  virtual bool solve(double* b, const std::function<bool(double*)>& middle) = 0;
  /// Pivots of A_ii.
  virtual PivotRange pivots() const = 0;
  virtual SolverStatistics statistics() const = 0;
};

/// Precision of the factors with which solutions are computed.
enum class Precision { full, single };

/// Using CHOLMOD: all of L is computed at once, the border's part in dense
/// blocks. The interior is ordered by minimum degree, or by nested dissection (METIS) if that leaves more than
/// `dissect_above` operations per entry of L. With single precision, S is as accurate, but solutions have about half of
/// the digits, as is enough for a preconditioner, and take half of the time.
std::unique_ptr<SchurSolver> make_schur_cholesky(double dissect_above, Precision precision = Precision::full);

} // namespace signorini::solve
