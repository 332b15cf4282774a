#pragma once
// What a factorisation will need, from the pattern alone.

#include "solve/linear.hpp"

namespace signorini::solve {

struct FactorEstimate {
  LinearKind kind; ///< `automatic` has become what it comes to
  double memory;   ///< bytes of the factors
};

/// Counts the entries of Cholesky's factor in the order of nested dissection (METIS); LU has two of them as long as
/// pivoting leaves that order alone; `banded` by its band. What `kept` and `condensed` add for the unknowns in contact
/// is not counted. Bytes that the solvers told, in parts of this, with 228 to 8,208 unknowns of degrees 2 and 4: KLU
/// and UMFPACK 0.86 to 1.06, CHOLMOD 0.70 to 1.06, kept 1.06 to 1.14, condensed 0.95 to 1.27, on long strips in contact
/// all along 3.8.
FactorEstimate estimate_factor(LinearKind kind, const Pattern& pattern);

} // namespace signorini::solve
