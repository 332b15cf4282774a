#include "nurbs/bezier.hpp"

#include <algorithm>
#include <vector>

namespace signorini::nurbs {

MatrixX bezier_extraction(const KnotVector& knots, int element) {
  const int p = knots.degree(), span = knots.span(element);
  const auto& u = knots.knots();
  const double start = u[static_cast<std::size_t>(span)], end = u[static_cast<std::size_t>(span) + 1];
  // Q_k is the blossom of the curve at (start, p−k times; end, k times): de Boor's recursion with one argument a level,
  // on unit control points.
  MatrixX extraction(p + 1, p + 1);
  for (int k = 0; k <= p; ++k) {
    MatrixX level = MatrixX::Identity(p + 1, p + 1);
    for (int r = 1; r <= p; ++r) {
      const double argument = r <= p - k ? start : end;
      for (int i = p; i >= r; --i) {
        const std::size_t left = static_cast<std::size_t>(span - p + i),
                          right = left + static_cast<std::size_t>(p + 1 - r);
        const double alpha = (argument - u[left]) / (u[right] - u[left]);
        level.col(i) = (1 - alpha) * level.col(i - 1) + alpha * level.col(i);
      }
    }
    extraction.col(k) = level.col(p);
  }
  return extraction;
}

void bernstein(int degree, double t, double length, int order, double* out) {
  const double s = 1 - t;
  double* value = out;
  double *slope = out + degree + 1, *curvature = out + 2 * (degree + 1);
  std::fill(out, out + (order + 1) * (degree + 1), 0.0);
  value[0] = 1;
  // B^q_k = s B^{q−1}_k + t B^{q−1}_{k−1};  ∂B^p_k = p (B^{p−1}_{k−1} − B^{p−1}_k);  ∂²B^p_k = p(p−1)(B^{p−2}_{k−2} −
  // 2B^{p−2}_{k−1} + B^{p−2}_k)
  for (int q = 1; q <= degree; ++q) {
    if (order > 1 && q == degree - 1) {
      const double scale = degree * (degree - 1) / (length * length);
      for (int k = 0; k < q; ++k) {
        curvature[k] += scale * value[k];
        curvature[k + 1] -= 2 * scale * value[k];
        curvature[k + 2] += scale * value[k];
      }
    }
    if (order > 0 && q == degree) {
      const double scale = degree / length;
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
