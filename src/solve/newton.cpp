#include "solve/newton.hpp"

#include "base/error.hpp"
#include "os/interrupt.hpp"
#include "os/limits.hpp"
#include "solve/constants.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace signorini::solve {

std::string name_of(Outcome outcome) {
  // In the order of the enumeration
  constexpr const char* names[] = {"iterating",       "converged", "iterations", "diverged",   "cycling",
                                   "lost_projection", "inverted",  "singular",   "indefinite", "nan",
                                   "line_search",     "crossed",   "interrupted"};
  static_assert(std::size(names) == static_cast<std::size_t>(Outcome::interrupted) + 1);
  return names[static_cast<std::size_t>(outcome)];
}

namespace {

/// Predicts r_{k+1} = C r_k² with C from the last two residuals; infinite if there are fewer.
double predicted_residual(const std::vector<double>& residuals) {
  const std::size_t n = residuals.size();
  if (n < 2) return std::numeric_limits<double>::infinity();
  const double last = residuals[n - 1], before = residuals[n - 2];
  return last * (last / before) * (last / before);
}

/// If quadratic convergence predicts the last iteration, the residual without the tangent is enough to confirm it.
bool needs_tangent(const NewtonReport& report) {
  return predicted_residual(report.residuals) > surely_below * report.tolerance;
}

/// True if the residual is near its rounding level and no longer decreases: Newton's method would at least halve it.
bool stagnates(const std::vector<double>& residuals, double floor) {
  const std::size_t n = residuals.size();
  return n >= 3 && residuals[n - 1] <= near_floor * floor && residuals[n - 1] > least_fall * residuals[n - 2] &&
         residuals[n - 2] <= near_floor * floor;
}

} // namespace

bool iterate(NewtonProblem& problem, const NewtonOptions& options, bool pending, NewtonReport& report) {
  const auto stop = [&](Outcome outcome, const Message& message) {
    report.outcome = outcome;
    if (!message.code.empty()) report.messages = {message};
    return false;
  };
  const auto stop_by_user = [&] {
    report_interrupt();
    return stop(Outcome::interrupted, out_of_time() ? Message("solve.newton.time", {{"limit", time_limit()}})
                                                    : Message("solve.newton.interrupted"));
  };
  // Steps that need no iteration can be interrupted too.
  if (report.residuals.empty() && interrupted()) return stop_by_user();
  const Iteration acknowledged;
  Message why;
  bool tangent = needs_tangent(report);
  if (const Outcome state = problem.evaluate(tangent, why); state != Outcome::converged) return stop(state, why);
  const double residual = problem.residual();
  report.residuals.push_back(residual);
  if (!std::isfinite(residual)) return stop(Outcome::not_finite, Message("solve.newton.not_finite"));

  // The rounding level is that of the present tangent: contact that has opened since the last one may have been stiff.
  const double tolerance = options.tolerance * problem.scale();
  if (!tangent && residual > tolerance) {
    if (const Outcome state = problem.evaluate(true, why); state != Outcome::converged) return stop(state, why);
    tangent = true;
  }
  const double floor = problem.floor();
  report.tolerance = tolerance + floor;
  const bool small_energy = residual <= floor || report.energies.empty() ||
                            report.energies.back() <= options.tolerance * report.energies.front();
  const bool waiting = pending && report.iterations == 0;
  const bool small = (residual <= report.tolerance && small_energy) || stagnates(report.residuals, floor);
  if (small && !waiting) {
    if (const Outcome end = problem.conclude(why); end != Outcome::iterating) return stop(end, why);
    report.begun = report.iterations;
    return true;
  }
  // The first residual is zero if the first solution only moves an obstacle.
  double first = report.residuals.front();
  if (pending && report.iterations > 0) first = std::max(first, report.residuals[1]);
  if (residual > divergence_growth * (problem.scale() + first))
    return stop(Outcome::diverged, Message("solve.newton.diverged", {{"residual", residual}}));
  if (report.iterations - report.begun >= options.iterations)
    return stop(Outcome::iteration_limit,
                Message(residual <= near_floor * floor ? "solve.newton.near_rounding" : "solve.newton.no_convergence",
                        {{"iterations", options.iterations}, {"residual", residual}, {"tolerance", report.tolerance}}));
  if (!tangent)
    if (const Outcome state = problem.evaluate(true, why); state != Outcome::converged) return stop(state, why);
  if (interrupted()) return stop_by_user();
  const std::optional<double> slope = problem.advance();
  if (!slope) return stop(Outcome::singular_tangent, Message("solve.newton.singular"));
  ++report.iterations;
  report.energies.push_back(std::abs(*slope));
  // The move that applies prescribed displacements must not be shortened.
  if (options.line_search == LineSearchKind::none || waiting) return true;
  // Along the last moves f·Δu is less than the error of iterative linear solutions.
  if (report.energies.back() <= options.tolerance * report.energies.front()) {
    report.parts.push_back(1);
    return true;
  }
  // The full move is accepted in most iterations.
  const auto trial = [&](double s) { return problem.retreat(s, s == 1 && needs_tangent(report)); };
  const std::optional<double> part = line_search(options.line_search, trial, report.residuals, *slope);
  if (!part) {
    problem.retreat(0, true); // to the state and the tangent that a diagnosis examines
    return stop(Outcome::line_search, Message("solve.newton.line_search", {{"residual", residual}}));
  }
  report.parts.push_back(*part);
  return true;
}

} // namespace signorini::solve
