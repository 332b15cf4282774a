#include "solve/newton.hpp"

#include "base/error.hpp"
#include "base/interrupt.hpp"

#include <cmath>

namespace signorini::solve {

std::string name_of(Outcome outcome) {
  switch (outcome) {
  case Outcome::converged:
    return "converged";
  case Outcome::iteration_limit:
    return "iterations";
  case Outcome::diverged:
    return "diverged";
  case Outcome::inverted_element:
    return "inverted";
  case Outcome::singular_tangent:
    return "singular";
  case Outcome::not_finite:
    return "nan";
  case Outcome::interrupted:
    return "interrupted";
  }
  return "";
}

NewtonReport newton(const NewtonSystem& system, const NewtonOptions& options, bool pending) {
  NewtonReport report;
  const auto stop = [&](Outcome outcome, std::string message) {
    report.outcome = outcome;
    report.message = std::move(message);
    return report;
  };
  for (;; ++report.iterations) {
    std::string why;
    if (const Outcome state = system.assemble(why); state != Outcome::converged) return stop(state, why);
    const double residual = system.residual();
    report.residuals.push_back(residual);
    if (!std::isfinite(residual)) return stop(Outcome::not_finite, "the residual is not a finite number");

    const double floor = system.floor(), enough = options.tolerance * system.scale() + floor;
    const bool small_energy = residual <= floor || report.energies.empty() ||
                              report.energies.back() <= options.tolerance * report.energies.front();
    if (residual <= enough && small_energy && !(pending && report.iterations == 0)) return report;
    // Far beyond anything that a Newton iteration recovers from
    constexpr double hopeless = 1e12;
    if (residual > hopeless * (system.scale() + report.residuals.front()))
      return stop(Outcome::diverged, text("the residual grew to ", residual));
    if (report.iterations == options.iterations)
      return stop(Outcome::iteration_limit, text("no convergence in ", options.iterations,
                                                 " iterations; the residual is ", residual, ", asked was ", enough));
    if (interrupted()) return stop(Outcome::interrupted, "stopped by Ctrl-C");
    double energy = 0;
    if (!system.advance(energy)) return stop(Outcome::singular_tangent, "the tangent is singular; is a body not held?");
    report.energies.push_back(energy);
  }
}

} // namespace signorini::solve
