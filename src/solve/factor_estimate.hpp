#pragma once
// What a factorization will need, from the pattern alone.

#include "solve/linear.hpp"

namespace signorini::solve {

struct FactorEstimate {
  LinearKind kind; ///< `automatic` has become what it comes to
  double memory;   ///< bytes of the factors
};

/// Counts the entries of Cholesky's factor in the order of nested dissection (METIS); LU has two of them as long as
/// pivoting leaves that order alone. What `kept` and `condensed` add for the unknowns in contact
/// is not counted.
FactorEstimate estimate_factor(LinearKind kind, const Pattern& pattern);

} // namespace signorini::solve
