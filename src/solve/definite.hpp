#pragma once
// The signs of the eigenvalues of a symmetric matrix.

#include "solve/pattern.hpp"

#include <optional>
#include <vector>

namespace signorini::solve {

/// True if all pivots of a symmetric matrix are positive, up to rounding errors of the factorization: by CHOLMOD's
/// LDLᵀ, or LLᵀ where the factors are large, ordered by minimum degree or nested dissection. `values` in the order of
/// the pattern; only the upper triangle is read.
bool is_positive_definite(const Pattern& pattern, const std::vector<double>& values);

/// The number of negative eigenvalues, which is that of negative pivots of L D Lᵀ (Sylvester's law of inertia). CHOLMOD
/// does not pivot for accuracy: nothing is returned where a pivot vanishes, or where a solution with the factors is
/// wrong by more than `reliable_factors`.
std::optional<int> negative_eigenvalues(const Pattern& pattern, const std::vector<double>& values);

} // namespace signorini::solve
