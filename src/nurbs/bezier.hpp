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
/// start + length·t. `out` holds order+1 rows of degree+1 values.
inline void bernstein(int degree, double t, double length, int order, double* out) {
  const int p = degree;
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

/// Variant with degree and order known at compile time; `scale` is 1/length.
template <int P, int Order> void bernstein(double t, double scale, double* __restrict out) {
  const double s = 1 - t;
  double b[P + 1] = {1};
#pragma GCC unroll 16
  for (int q = 1; q <= P; ++q) {
    if (Order > 1 && q == P - 1)
#pragma GCC unroll 16
      for (int k = 0; k <= P; ++k) {
        const double before = k > 1 ? b[k - 2] : 0, middle = k > 0 && k < P ? b[k - 1] : 0,
                     after = k < P - 1 ? b[k] : 0;
        out[2 * (P + 1) + k] = P * (P - 1) * scale * scale * (before - 2 * middle + after);
      }
    if (Order > 0 && q == P)
#pragma GCC unroll 16
      for (int k = 0; k <= P; ++k) out[P + 1 + k] = P * scale * ((k > 0 ? b[k - 1] : 0) - (k < P ? b[k] : 0));
#pragma GCC unroll 16
    for (int k = q; k > 0; --k) b[k] = s * b[k] + t * b[k - 1];
    b[0] *= s;
  }
  for (int k = 0; k <= P; ++k) out[k] = b[k];
  if (Order > 1 && P == 1) out[4] = out[5] = 0;
}

} // namespace signorini::nurbs
