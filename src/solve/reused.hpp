#pragma once
// A factorization that outlives its matrix: the preconditioner of GMRES on the tangents that follow.

#include "solve/linear.hpp"
#include "solve/symmetric_part.hpp"

namespace signorini::solve {

/// GMRES on the present matrix, preconditioned by a factorization of an earlier one: of its symmetric part, whose block
/// of the watched unknowns is kept up to date, where one is given and can be factored; elsewhere of `direct`, any
/// direct solver. A factorization can cost hundreds of solutions, while tangents of one step differ little. It is
/// renewed when solutions get more expensive than they have been on average since the last renewal, that one included:
/// the optimal time if the price keeps rising. Costs are counted, not measured, so the same matrices give the same bits
/// on every run; a solver that does not tell them is taken for as expensive as the most iterations of GMRES.
///
/// Accuracy: see Forcing for the first right-hand side after factor(), which is taken for Newton's; others are solved
/// to Forcing::tightest. A matrix that is singular to working precision is reported where the right-hand side shows it:
/// where that can be balanced, one of its solutions is returned.
std::unique_ptr<LinearSolver> make_reused(const Pattern& pattern, MakeDirect direct,
                                          std::unique_ptr<SymmetricPart> symmetric_part = nullptr);

/// How exactly Newton's corrections are wanted, from the residuals r_k that they are to remove (Eisenstat & Walker,
/// SIAM J. Sci. Comput. 17, 1996, choice 2): quadratic convergence leaves r_k (r_k / r_{k−1})² after the next
/// correction, and the linear system a tenth of that.
class Forcing {
public:
  /// Looser ones cost Newton iterations; tighter ones nothing but iterations of GMRES, since Newton asks for no more.
  static constexpr double loosest = 1e-3, tightest = 1e-10;
  /// ‖b − K x‖ / ‖b‖ for the right-hand side of this norm. Where the norm has grown, a new step begins: its first
  /// correction is expected to do as well as that of the step before.
  double next(double norm);

private:
  /// Of what quadratic convergence leaves, so that the linear system's error does not count; and what a first
  /// correction is expected to leave, where nothing is known.
  static constexpr double small_part = 0.1, first_guess = 0.1;
  double last_ = 0, first_reduction_ = first_guess;
  bool began_ = false;
};

} // namespace signorini::solve
