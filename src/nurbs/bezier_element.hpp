#pragma once
// One element of a discretization as a tensor product of Bernstein polynomials, exact also where rows of different
// degrees meet.

#include "nurbs/discretization.hpp"

namespace signorini::nurbs {

/// The functions of an element, w_A N_A(ξ) = w_A Σ_k extraction(A, k) B_k(t): weighted control points of its Bézier
/// form are the columns of homogeneous(functions) · extraction, k running fastest in ξ¹.
struct BezierElement {
  std::vector<int> degrees;   ///< per parametric direction, the highest of the functions on the element
  std::vector<int> functions; ///< A
  MatrixX extraction;         ///< functions × Bézier points
};
BezierElement bezier_element(const Discretization& space, int e);

/// E with B^from_k = Σ_j E(k, j) B^to_j, (from+1) × (to+1).
MatrixX bernstein_elevation(int from, int to);

} // namespace signorini::nurbs
