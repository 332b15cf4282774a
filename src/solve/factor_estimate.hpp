#pragma once
// Estimated memory of a factorization, from the pattern alone.

#include "solve/linear.hpp"

namespace signorini::solve {

struct FactorEstimate {
  LinearKind kind; ///< the kind that `automatic` selects, otherwise the given one
  double memory;   ///< bytes of the factors
};

/// Counts the entries of the Cholesky factor in nested dissection order (METIS); LU has two such factors as long as
/// pivoting does not change the order. The additional memory of `reuse` and `condensed` for the contact unknowns is not
/// counted.
FactorEstimate estimate_factor(LinearKind kind, const Pattern& pattern);

} // namespace signorini::solve
