#pragma once
// Gauss–Legendre quadrature on an interval.

#include <vector>

namespace signorini::solid {

struct QuadratureRule {
  std::vector<double> points, weights;
};

/// Gauss–Legendre rule of n points on [a, b]; exact for polynomials of degree 2n−1. Throws Error for n < 1.
QuadratureRule gauss_legendre(int n, double a, double b);

} // namespace signorini::solid
