#pragma once
// Checks if a symmetric matrix is positive definite.

#include "solve/pattern.hpp"

#include <vector>

namespace signorini::solve {

/// True if all pivots of a symmetric matrix are positive, up to rounding errors of the factorization: by CHOLMOD's
/// LDLᵀ, or LLᵀ where the factors are large, ordered by minimum degree or nested dissection. `values` in the order of
/// the pattern; only the upper triangle is read.
bool is_positive_definite(const Pattern& pattern, const std::vector<double>& values);

} // namespace signorini::solve
