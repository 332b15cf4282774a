#pragma once
// Gauss–Legendre quadrature on intervals and boxes.

#include "base/eigen.hpp"

#include <vector>

namespace signorini::solid {

struct QuadratureRule {
  std::vector<double> points, weights;
};

/// Gauss–Legendre rule of n points on [a, b]; exact for polynomials of degree 2n−1. Throws Error for n < 1.
QuadratureRule gauss_legendre(int n, double a, double b);

/// Points of a parametric box (columns) and their weights.
struct ElementQuadrature {
  MatrixX points;
  VectorX weights;
};
/// The tensor product of one rule per parametric direction, ξ¹ fastest.
ElementQuadrature tensor_product(const std::vector<QuadratureRule>& rules);

} // namespace signorini::solid
