#pragma once
// KLU, for small tangents.

#include "solve/linear.hpp"

namespace signorini::solve {

/// LU with the pivots of the last full factorisation as long as they serve. The statistics tell the operations that the
/// analysis expects before the first factorisation.
std::unique_ptr<LinearSolver> make_klu(const Pattern& pattern);

} // namespace signorini::solve
