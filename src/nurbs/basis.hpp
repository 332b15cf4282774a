#pragma once
// Basis functions of one direction; of B-splines as in Piegl & Tiller, The NURBS Book, 2nd ed., algorithm A2.3.

#include "nurbs/space1d.hpp"

namespace signorini::nurbs {

/// The degree+1 functions that do not vanish on an element, and their derivatives up to `order`, at xi.
///
/// `out` holds (order+1)·(degree+1) values, row k = k-th derivatives of functions first_function(element) …; rows above
/// the degree are zero. xi may lie outside the element: the element's polynomial is continued. No allocation.
void basis_derivatives(const KnotVector& knots, int element, double xi, int order, double* out);
/// Likewise for any space: rows of functions_on(element).size() values. Computed from the knots if the space has them,
/// otherwise by Bézier extraction, for orders up to 2.
void basis_derivatives(const Space1D& space, int element, double xi, int order, double* out);

} // namespace signorini::nurbs
