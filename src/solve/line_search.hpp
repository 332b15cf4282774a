#pragma once
// How far to go along Newton's direction.

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace signorini::solve {

enum class LineSearchKind { none, residual, energy };

/// "none", "residual", "energy". Throws Error that lists them.
LineSearchKind line_search_kind(const std::string& name);

/// The state at a part of the move: 2-norm of the residual f and f·Δu.
struct Trial {
  double residual, slope;
};

/// The part s ≤ 1 of the move Δu to take, the state being left there; nothing when no s down to 1/128 will do.
/// `evaluate` moves to a part and looks.
///
/// By residual (L. Grippo, F. Lampariello, S. Lucidi, SIAM J. Numer. Anal. 23, 1986): the first of s = 1 and those that
/// quadratic interpolation gives with |f(s)| ≤ (1 − s/10⁴) max |f|, the maximum over the last four iterations, so that
/// points that begin to touch may raise it for a while.
///
/// By energy (H. Matthies, G. Strang, Int. J. Numer. Meth. Engng 14, 1979): s = 1 unless f(s)·Δu has changed its sign
/// and is still more than half as large as f(0)·Δu = `slope`; then the place where regula falsi finds it small. Where
/// the move leads to no state at all it is halved until there is one.
std::optional<double> line_search(LineSearchKind kind, const std::function<Trial(double)>& evaluate,
                                  const std::vector<double>& residuals, double slope);

} // namespace signorini::solve
