#pragma once
// A reused (lagged) factorization as preconditioner of GMRES on later tangents.

#include "solve/constants.hpp"
#include "solve/linear.hpp"
#include "solve/symmetric_part.hpp"

namespace signorini::solve {

/// GMRES on the current matrix, preconditioned by a factorization of an earlier one: of its symmetric part, in which
/// the block of the watched unknowns is updated, if `symmetric_part` is given and can be factored; otherwise by
/// `direct`, any direct solver. A factorization can cost as much as hundreds of solutions, while the tangents of one
/// step differ little. It is renewed when the iterations since the last renewal, beyond those that a new factorization
/// would have needed for the same digits, cost as much as a renewal: at most twice the least total cost, and the least
/// if the cost rises steadily. Costs are counted, not measured, so results are bitwise reproducible; a solver that does
/// not report its operations is assumed to cost as much as the maximum number of GMRES iterations.
///
/// Accuracy: see Forcing for the first right-hand side after factor(), which is assumed to be Newton's; others, and
/// those that are to be solved fully, are solved to tightest_tolerance. A matrix that is singular to working precision
/// is reported if the system with this right-hand side has no solution; otherwise one of its solutions is returned.
/// `kind` is the name under which the user has selected it.
std::unique_ptr<LinearSolver> make_reused(const Pattern& pattern, MakeDirect direct,
                                          std::unique_ptr<SymmetricPart> symmetric_part = nullptr,
                                          double loosest = loosest_tolerance, LinearKind kind = LinearKind::reuse);

/// Accuracy of Newton's corrections, from the residuals r_k that they are to remove (Eisenstat & Walker, SIAM J. Sci.
/// Comput. 17, 1996, choice 2): quadratic convergence leaves r_k (r_k / r_{k−1})² after the next correction; the linear
/// system is solved to a tenth of that.
class Forcing {
public:
  explicit Forcing(double loosest = loosest_tolerance) : loosest_(loosest) {}
  /// Tolerance of ‖b − K x‖ / ‖b‖ for a right-hand side of this norm. A larger norm than before means a new step: its
  /// first correction is expected to converge as well as that of the previous step.
  double next(double norm);

private:
  /// Fraction of the residual left by quadratic convergence, so that the linear system's error is negligible; and the
  /// reduction expected of a first correction without history.
  static constexpr double small_part = 0.1, first_guess = 0.1;
  double loosest_;
  double last_ = 0, first_reduction_ = first_guess;
  bool began_ = false;
};

} // namespace signorini::solve
