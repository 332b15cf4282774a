#pragma once
// The Bézier form of one element: Bernstein polynomials and the extraction that turns B-spline functions into them.

#include "base/eigen.hpp"
#include "nurbs/knots.hpp"

namespace signorini::nurbs {

/// C with N_a(ξ) = Σ_k C(a, k) B_k(t) on an element, a counted from its first function, t = (ξ − start)/(end − start).
/// (degree+1)², entries ≥ 0, columns sum to 1; Bézier points are Q_k = Σ_a C(a, k) P_a (Borden et al., IJNME 87, 2011).
MatrixX bezier_extraction(const KnotVector& knots, int element);

/// The degree+1 Bernstein polynomials at t ∈ [0, 1] and their derivatives up to `order` (0, 1 or 2) with respect to
/// ξ = start + length·t. `out` holds order+1 rows of degree+1 values.
void bernstein(int degree, double t, double length, int order, double* out);

} // namespace signorini::nurbs
