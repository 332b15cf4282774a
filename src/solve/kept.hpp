#pragma once
// A factorisation that outlives its matrix: the preconditioner of GMRES on the tangents that follow.

#include "solve/linear.hpp"

namespace signorini::solve {

/// GMRES on the present matrix, preconditioned by Cholesky's factorisation of the symmetric part of an earlier one, its
/// block of the watched unknowns kept up to date (see SymmetricPart), or by LU where that part is not positive
/// definite. In three dimensions a factorisation costs tens of solutions, while tangents of one step differ little. It
/// is renewed when solutions get dearer than they have been on average since the last renewal, that one included: the
/// optimal time if the price keeps rising. Costs are counted, not measured, so the same matrices give the same bits on
/// every run.
///
/// Accuracy: see Forcing for the first right-hand side after factor(), which is taken for Newton's; others are solved
/// to Forcing::tightest. A matrix that is singular to working precision is reported where the right-hand side shows it:
/// where that can be balanced, one of its solutions is returned.
std::unique_ptr<LinearSolver> make_kept(const Pattern& pattern);

/// How exactly Newton's corrections are wanted, from the residuals r_k that they are to remove (Eisenstat & Walker,
/// SIAM J. Sci. Comput. 17, 1996, choice 2): quadratic convergence leaves r_k (r_k / r_{k−1})² after the next
/// correction, and the linear system a tenth of that.
class Forcing {
public:
  static constexpr double loosest = 1e-3, tightest = 1e-10;
  /// ‖b − K x‖ / ‖b‖ for the right-hand side of this norm. Where the norm has grown, a new step begins: its first
  /// correction is expected to do as well as that of the step before.
  double next(double norm);

private:
  double last_ = 0, first_reduction_ = 0.1;
  bool began_ = false;
};

} // namespace signorini::solve
