#include "solid/quadrature.hpp"

#include "base/error.hpp"

#include <cmath>
#include <numbers>

namespace signorini::solid {

QuadratureRule gauss_legendre(int n, double a, double b) {
  require(n >= 1, "a quadrature rule needs at least 1 point, got ", n);
  QuadratureRule rule{std::vector<double>(static_cast<std::size_t>(n)),
                      std::vector<double>(static_cast<std::size_t>(n))};
  for (int i = 0; i < n; ++i) {
    // Newton on P_n from Tricomi's start; the three-term recurrence gives P_n and P_{n−1}.
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), slope = 1;
    for (int iteration = 0; iteration < 100; ++iteration) {
      double previous = 1, value = x;
      for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * previous) / k;
        previous = value;
        value = next;
      }
      slope = n * (x * value - previous) / (x * x - 1);
      const double step = value / slope;
      x -= step;
      if (std::abs(step) < 1e-15) break;
    }
    const std::size_t k = static_cast<std::size_t>(i);
    rule.points[k] = 0.5 * (a + b) + 0.5 * (b - a) * x;
    // w_i = 2 / ((1 − x²) P_n'²)
    rule.weights[k] = (b - a) / ((1 - x * x) * slope * slope);
  }
  return rule;
}

} // namespace signorini::solid
