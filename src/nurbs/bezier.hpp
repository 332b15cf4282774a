#pragma once
// Bernstein polynomials, and the extraction that expresses the B-splines of one element by them.

#include "base/eigen.hpp"
#include "nurbs/knots.hpp"

#include <algorithm>

namespace signorini::nurbs {

/// C with N_a(ξ) = Σ_k C(a, k) B_k(t) on an element, a counted from its first function, t = (ξ − start)/(end − start).
/// (degree+1)², entries ≥ 0, columns sum to 1; Bézier points are Q_k = Σ_a C(a, k) P_a (Borden et al., IJNME 87, 2011).
MatrixX bezier_extraction(const KnotVector& knots, int element);

/// The degree+1 Bernstein polynomials at t ∈ [0, 1] and their derivatives up to `order` (0, 1 or 2) with respect to ξ =
/// start + length·t. `out` holds order+1 rows of degree+1 values. P: the degree if known at compile time, otherwise 0.
template <int P = 0> void bernstein(int degree, double t, double length, int order, double* out) {
  const int p = P > 0 ? P : degree;
  const double s = 1 - t;
  double* value = out;
  double *slope = value + p + 1, *curvature = slope + p + 1;
  std::fill_n(out, (order + 1) * (p + 1), 0.0);
  value[0] = 1;
  // B^q_k = s B^{q−1}_k + t B^{q−1}_{k−1};  ∂B^p_k = p (B^{p−1}_{k−1} − B^{p−1}_k);  ∂²B^p_k = p(p−1)(B^{p−2}_{k−2} −
  // 2B^{p−2}_{k−1} + B^{p−2}_k)
  for (int q = 1; q <= p; ++q) {
    if (order > 1 && q == p - 1) {
      const double scale = p * (p - 1) / (length * length);
      for (int k = 0; k < q; ++k) {
        curvature[k] += scale * value[k];
        curvature[k + 1] -= 2 * scale * value[k];
        curvature[k + 2] += scale * value[k];
      }
    }
    if (order > 0 && q == p) {
      const double scale = p / length;
      for (int k = 0; k < q; ++k) {
        slope[k] -= scale * value[k];
        slope[k + 1] += scale * value[k];
      }
    }
    double left = 0;
    for (int k = 0; k <= q; ++k) {
      const double own = k < q ? value[k] : 0;
      value[k] = s * own + t * left;
      left = own;
    }
  }
}

} // namespace signorini::nurbs
