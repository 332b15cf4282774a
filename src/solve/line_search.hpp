#pragma once
// Step length along Newton's direction [theory 10.8].

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace signorini::solve {

enum class LineSearchKind { none, residual, energy };

/// "none", "residual", "energy". Throws Error that lists them.
LineSearchKind line_search_kind(const std::string& name);

/// The state after a fraction of the move: 2-norm of the residual f, and f·Δu.
struct Trial {
  double residual, slope;
};

/// The fraction s ≤ 1 of the move Δu to take, at which the state is left; nothing if no s down to 1/128 is acceptable.
/// `evaluate` moves to a fraction and evaluates it.
///
/// By residual (L. Grippo, F. Lampariello, S. Lucidi, SIAM J. Numer. Anal. 23, 1986): the first of s = 1 and the values
/// of quadratic interpolation with |f(s)| ≤ (1 − s/10⁴) max |f|, the maximum over the last four iterations, so that
/// points that come into contact may increase it temporarily.
///
/// By energy (H. Matthies, G. Strang, Int. J. Numer. Meth. Engng 14, 1979): s = 1 unless f(s)·Δu has changed its sign
/// and is still more than half as large as f(0)·Δu = `slope`; then the s at which the Illinois form of regula falsi
/// (M. Dowell, P. Jarratt, BIT 11, 1971) makes it small. If the move leads to an invalid state, it is halved until the
/// state is valid.
std::optional<double> line_search(LineSearchKind kind, const std::function<Trial(double)>& evaluate,
                                  const std::vector<double>& residuals, double slope);

} // namespace signorini::solve
