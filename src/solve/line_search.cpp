#include "solve/line_search.hpp"

#include "base/error.hpp"
#include "solve/constants.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::solve {

namespace {

std::optional<double> by_residual(const std::function<Trial(double)>& evaluate, const std::vector<double>& residuals) {
  const std::size_t first = residuals.size() - std::min(residuals.size(), residual_memory);
  const double highest = *std::max_element(residuals.begin() + static_cast<std::ptrdiff_t>(first), residuals.end());
  const double start = residuals.back();
  for (double s = 1; s >= shortest_part;) {
    const double now = evaluate(s).residual;
    if (now <= (1 - least_decrease * s) * highest) return s;
    // φ(s) = |f|², φ(0) = start², φ′(0) = −2 start² for the consistent tangent: the parabola through φ(s) has its
    // minimum at
    //   s* = start² s² / (φ(s) − start² + 2 start² s)
    const double ratio = (now / start) * (now / start);
    const double next = s * s / (ratio - 1 + 2 * s);
    // The parabola is undefined if the state is invalid.
    s = std::isfinite(now) ? std::clamp(next, most_shortened * s, least_shortened * s) : least_shortened * s;
  }
  return std::nullopt;
}

std::optional<double> by_energy(const std::function<Trial(double)>& evaluate, double slope) {
  // f·Δu changes its sign between low and high; its value at high is 0 while nothing is known of it.
  double low = 0, low_slope = slope, high = 1, high_slope = 0;
  double s = 1;
  for (int i = 0; i < most_slope_trials && s >= shortest_part; ++i) {
    const Trial now = evaluate(s);
    if (!std::isfinite(now.residual)) { // invalid state: shorten
      high = s;
      high_slope = 0;
      s = 0.5 * (low + s);
      continue;
    }
    if (std::abs(now.slope) <= slope_tolerance * std::abs(slope)) return s;
    // Regula falsi, with the value at an end that stays halved (Illinois), and with a distance from the ends
    if (now.slope * slope > 0) { // too short; accepted at the end of the move or of the valid states
      if (high_slope == 0) return s;
      low = s;
      low_slope = now.slope;
      high_slope *= 0.5;
    } else {
      if (high_slope != 0) low_slope *= 0.5;
      high = s;
      high_slope = now.slope;
    }
    const double root = low + (high - low) * low_slope / (low_slope - high_slope);
    s = std::clamp(root, low + most_shortened * (high - low), high - most_shortened * (high - low));
  }
  return std::nullopt;
}

} // namespace

LineSearchKind line_search_kind(const std::string& name) {
  if (name == "none") return LineSearchKind::none;
  if (name == "residual") return LineSearchKind::residual;
  if (name == "energy") return LineSearchKind::energy;
  fail("solve.line_search.unknown", {{"name", name}});
}

std::optional<double> line_search(LineSearchKind kind, const std::function<Trial(double)>& evaluate,
                                  const std::vector<double>& residuals, double slope) {
  return kind == LineSearchKind::residual ? by_residual(evaluate, residuals) : by_energy(evaluate, slope);
}

} // namespace signorini::solve
