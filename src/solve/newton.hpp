#pragma once
// Newton's method on callbacks, iteration by iteration: the caller assembles, factors and updates; the order of things
// and the tests live here.

#include "base/message.hpp"
#include "solve/line_search.hpp"

#include <functional>
#include <string>
#include <vector>

namespace signorini::solve {

/// How a Newton iteration stands or ended. What a reason is called is in name_of().
enum class Outcome {
  iterating,
  converged,
  iteration_limit,
  diverged,        ///< the residual grew beyond all bounds
  cycling,         ///< states of contact points repeat
  lost_projection, ///< touching points come and go beyond an open end of the master
  inverted_element,
  singular_tangent,
  indefinite, ///< no convergence where the tangent has directions of negative stiffness
  not_finite,
  line_search, ///< no length of the move lowers the residual
  penetration, ///< augmentation does not bring it below its tolerance
  interrupted
};

/// "iterating", "converged", "iterations", "diverged", "cycling", "lost_projection", "inverted", "singular",
/// "indefinite", "nan", "line_search", "penetration", "interrupted".
std::string name_of(Outcome outcome);

struct NewtonOptions {
  double tolerance = 1e-10; ///< of the residual, relative to the forces of the run
  int iterations = 25;      ///< most linear solves in one step
  LineSearchKind line_search = LineSearchKind::none;
};

/// What the loop needs from a system of equations.
struct NewtonSystem {
  /// Residual and, when wanted, tangent at the present state. Returns converged, or why there are none or why going on
  /// is in vain (message in `why`).
  std::function<Outcome(bool tangent, Message& why)> assemble;
  /// 2-norm of the residual of the free unknowns.
  std::function<double()> residual;
  /// The residual that counts as zero is tolerance·scale() + floor(): scale is the size of the forces in the run so
  /// far, floor what rounding leaves of the residual.
  std::function<double()> scale, floor;
  /// Factors, solves and moves the state by Δu. Returns false when the tangent is singular; sets |f·Δu|.
  std::function<bool(double& energy)> advance;
  /// For line search: moves the state to the part s of the last Δu, evaluates the residual there, and returns its norm
  /// and f·Δu; infinite where there is no residual.
  std::function<Trial(double part)> retreat = {};
  /// f·Δu in the state before the last Δu, signed; for line search by energy.
  std::function<double()> slope = {};
  /// Called when the residual is small enough: releases what was held back, improves what is approximate. Returns
  /// converged when there was nothing to do, iterating when the residual has to be looked at again, or why it failed.
  std::function<Outcome(Message& why)> conclude = {};
};

struct NewtonReport {
  Outcome outcome = Outcome::iterating;
  int iterations = 0;            ///< linear solves
  std::vector<double> residuals; ///< before each solve, and at the end
  std::vector<double> energies;  ///< |f·Δu| of each solve
  std::vector<double> parts;     ///< of each Δu that a line search left; empty without
  double enough = 0;             ///< the residual that counts as zero
  int begun = 0;                 ///< iterations before conclude() last asked for more
  std::vector<Message> messages; ///< what went wrong
};

/// One iteration: evaluates, tests, and unless that ends it solves and moves. Returns whether it goes on; `report` is
/// its whole memory. It has converged when the residual is below tolerance·scale + floor and |f·Δu| has fallen below
/// tolerance times its first value in this step (thesis Algorithm 1, with the absolute value that its sign needs), or
/// when it stagnates within ten times the floor.
/// `pending` says that prescribed displacements wait to be applied by the first solve, so that a small residual before
/// it means nothing.
bool iterate(const NewtonSystem& system, const NewtonOptions& options, bool pending, NewtonReport& report);

/// Iterates to the end.
NewtonReport newton(const NewtonSystem& system, const NewtonOptions& options, bool pending);

} // namespace signorini::solve
