#pragma once
// CHOLMOD for symmetric tangents.

#include "solve/linear.hpp"

namespace signorini::solve {

/// L Lᵀ while the matrix is positive definite, L D Lᵀ otherwise, and UMFPACK where that finds no usable pivots.
/// factor() throws Error when the values are not symmetric.
std::unique_ptr<LinearSolver> make_cholesky(const Pattern& pattern);

} // namespace signorini::solve
