#pragma once
// Newton's method on callbacks: the caller assembles, factors and updates; the loop and its tests live here.

#include <functional>
#include <string>
#include <vector>

namespace signorini::solve {

enum class Outcome {
  converged,
  iteration_limit,
  diverged,
  inverted_element,
  singular_tangent,
  not_finite,
  interrupted
};

/// "converged", "iterations", "diverged", "inverted", "singular", "nan", "interrupted".
std::string name_of(Outcome outcome);

struct NewtonOptions {
  double tolerance = 1e-10; ///< of the residual, relative to the forces of the run
  int iterations = 25;      ///< most linear solves in one step
};

/// What the loop needs from a system of equations.
struct NewtonSystem {
  /// Residual and, when wanted, tangent at the present state. Returns converged, or why there are none (message in
  /// `why`).
  std::function<Outcome(bool tangent, std::string& why)> assemble;
  /// 2-norm of the residual of the free unknowns.
  std::function<double()> residual;
  /// The residual that counts as zero is tolerance·scale() + floor(): scale is the size of the forces in the run so
  /// far, floor what rounding leaves of the residual.
  std::function<double()> scale, floor;
  /// Factors, solves and moves the state by Δu. Returns false when the tangent is singular; sets |f·Δu|.
  std::function<bool(double& energy)> advance;
};

struct NewtonReport {
  Outcome outcome = Outcome::converged;
  int iterations = 0;            ///< linear solves
  std::vector<double> residuals; ///< before each solve, and at the end
  std::vector<double> energies;  ///< |f·Δu| of each solve
  std::string message;           ///< what went wrong, in words
};

/// Iterates until the residual is below tolerance·scale + floor and |f·Δu| has fallen below tolerance times its first
/// value in this step (thesis Algorithm 1, with the absolute value that its sign needs). `pending` says that prescribed
/// displacements wait to be applied by the first solve, so that a small residual before it means nothing.
NewtonReport newton(const NewtonSystem& system, const NewtonOptions& options, bool pending);

} // namespace signorini::solve
