#pragma once
// B-spline basis functions of one direction (Piegl & Tiller, The NURBS Book, 2nd ed., algorithm A2.3).

#include "nurbs/knots.hpp"

namespace signorini::nurbs {

/// The degree+1 functions that do not vanish on an element, and their derivatives up to `order`, at xi.
///
/// `out` holds (order+1)·(degree+1) values, row k = k-th derivatives of functions first_function(element) …; rows above
/// the degree are zero. xi may lie outside the element: the element's polynomial is continued. No allocation.
void basis_derivatives(const KnotVector& knots, int element, double xi, int order, double* out);

} // namespace signorini::nurbs
