#pragma once
// Linear least squares with bounds, for few unknowns.

#include "base/eigen.hpp"

namespace signorini {

/// The d with low ≤ d ≤ high of least ‖A d − b‖, by the active-set method of Stark and Parker (Computational Statistics
/// 10, 1995, pp. 129–141), begun with all unknowns free at d = 0, which must lie within the bounds. Unknowns that A
/// does not determine get the free solution of least norm. A: m × n, b: m; bounds may be infinite.
VectorX box_least_squares(const MatrixX& a, const VectorX& b, const VectorX& low, const VectorX& high);

} // namespace signorini
