#pragma once
// Newton's method, iteration by iteration: a problem evaluates, solves and moves; this module defines the order of
// operations and the convergence tests.

#include "base/message.hpp"
#include "solve/line_search.hpp"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace signorini::solve {

/// State of a Newton iteration, or how it ended. name_of() returns the names.
enum class Outcome {
  iterating,
  converged,
  iteration_limit,
  diverged,        ///< the residual grew beyond the limit
  cycling,         ///< contact states repeat
  lost_projection, ///< contact points alternately find and lose their projection at an open end of the master
  inverted_element,
  singular_tangent,
  indefinite, ///< no convergence where the tangent has negative eigenvalues
  not_finite,
  line_search, ///< no length of the move reduces the residual
  crossed,     ///< contact points have passed through the master
  interrupted
};

/// "iterating", "converged", "iterations", "diverged", "cycling", "lost_projection", "inverted", "singular",
/// "indefinite", "nan", "line_search", "crossed", "interrupted".
std::string name_of(Outcome outcome);

struct NewtonOptions {
  double tolerance = 1e-10; ///< of the residual, relative to the forces of the run
  int iterations = 25;      ///< limit of linear solves in one step
  LineSearchKind line_search = LineSearchKind::none;
};

/// A system of equations and its state, which Newton's method moves. Functions are in the order of their calls in an
/// iteration.
class NewtonProblem {
public:
  virtual ~NewtonProblem() = default;
  /// Evaluates the residual and, if `tangent`, the tangent at the current state. Returns converged, or the reason why
  /// they do not exist or continuing is useless (message in `why`).
  virtual Outcome evaluate(bool tangent, Message& why) = 0;
  /// 2-norm of the residual f of the free unknowns.
  virtual double residual() const = 0;
  /// The residual tolerance is tolerance·scale() + floor(): scale is the magnitude of the forces in the run so far,
  /// floor the rounding level of the residual.
  virtual double scale() const = 0;
  virtual double floor() const = 0;
  /// Called when the residual is small enough: ends aids such as frozen contact states, updates multipliers. Returns
  /// converged if nothing was left to do, iterating if the residual has to be tested again, or a reason of failure.
  virtual Outcome conclude(Message& /*why*/) { return Outcome::converged; }
  /// Factors, solves, and moves the state by Δu. Returns f·Δu; nothing if the tangent is singular.
  virtual std::optional<double> advance() = 0;
  /// For line search: moves the state to a fraction of the last Δu, evaluates the residual there, and returns its norm
  /// and f·Δu; infinite if the state is invalid. `tangent`: evaluate() will want that of this state, if it is accepted.
  virtual Trial retreat(double /*part*/, bool /*tangent*/) { return {std::numeric_limits<double>::infinity(), 0}; }
};

struct NewtonReport {
  Outcome outcome = Outcome::iterating;
  int iterations = 0;            ///< linear solves
  std::vector<double> residuals; ///< before each solve, and at the end
  std::vector<double> energies;  ///< |f·Δu| of each solve
  std::vector<double> parts;     ///< accepted fractions of Δu by line search; empty without
  double tolerance = 0;          ///< tolerance of the residual
  int begun = 0;                 ///< iterations before conclude() last requested more
  std::vector<Message> messages; ///< reasons of failure
};

/// One iteration [theory 10.1]: evaluates and tests, and unless that ends it, solves and moves. Returns whether to
/// continue; all state is in `report`. It has converged if the residual is below tolerance·scale + floor and |f·Δu| has
/// fallen below tolerance times its first value in this step (thesis Algorithm 1, with the absolute value that its sign
/// needs), or if it stagnates within ten times the floor. `pending`: prescribed displacements are applied by the first
/// solve, so that a small residual before it is not convergence.
bool iterate(NewtonProblem& problem, const NewtonOptions& options, bool pending, NewtonReport& report);

} // namespace signorini::solve
