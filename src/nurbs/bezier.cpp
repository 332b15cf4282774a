#include "nurbs/bezier.hpp"

#include <vector>

namespace signorini::nurbs {

MatrixX bezier_extraction(const KnotVector& knots, int element) {
  const int p = knots.degree(), span = knots.span(element);
  const double start = knots.breaks()[element], end = knots.breaks()[element + 1];
  const auto& u = knots.knots();
  // Q_k is the blossom of the curve at (start, p−k times; end, k times): de Boor's recursion with one argument per
  // level, applied to unit control points.
  MatrixX extraction(p + 1, p + 1);
  for (int k = 0; k <= p; ++k) {
    MatrixX level = MatrixX::Identity(p + 1, p + 1);
    for (int r = 1; r <= p; ++r) {
      const double argument = r <= p - k ? start : end;
      for (int i = p; i >= r; --i) {
        const std::size_t left = span - p + i, right = left + p + 1 - r;
        const double alpha = (argument - u[left]) / (u[right] - u[left]);
        level.col(i) = (1 - alpha) * level.col(i - 1) + alpha * level.col(i);
      }
    }
    extraction.col(k) = level.col(p);
  }
  return extraction;
}

} // namespace signorini::nurbs
