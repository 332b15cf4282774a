#pragma once
// LAPACK's band factorisations for tangents of slender bodies.

#include "solve/linear.hpp"

namespace signorini::solve {

/// Cholesky while the matrix is symmetric and positive definite, row-pivoted LU otherwise, on the band that is left
/// after reordering. Memory: 3 size × band width values.
std::unique_ptr<LinearSolver> make_banded(const Pattern& pattern);

} // namespace signorini::solve
