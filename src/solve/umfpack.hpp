#pragma once
// UMFPACK, for tangents of any kind.

#include "solve/linear.hpp"

namespace signorini::solve {

/// Multifrontal LU with threshold pivots, ordered by nested dissection (METIS). Its solve() reads no values: it may be
/// called when they are gone.
std::unique_ptr<LinearSolver> make_umfpack(const Pattern& pattern);

} // namespace signorini::solve
