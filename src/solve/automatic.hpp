#pragma once
// The choice between the solvers, from what a factorisation costs.

#include "solve/linear.hpp"

namespace signorini::solve {

/// KLU, and `kept` in its place where a factorisation is worth many solutions.
std::unique_ptr<LinearSolver> make_automatic(const Pattern& pattern);

/// Whether a direct factorisation costs so many solutions that it should be kept: its operations, and the entries that
/// a solution reads.
bool worth_keeping(double operations, double entries);

} // namespace signorini::solve
