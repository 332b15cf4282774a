#include "solid/quadrature.hpp"

#include "base/error.hpp"

#include <cmath>
#include <numbers>

namespace signorini::solid {

namespace {

constexpr int most_known = 16;

/// Points x of a rule on [−1, 1], and (1 − x²) P_n'(x)² for its weights.
QuadratureRule roots(int n) {
  QuadratureRule rule{std::vector<double>(n), std::vector<double>(n)};
  for (int i = 0; i < n; ++i) {
    // Newton's method on P_n from Tricomi's estimate; the three-term recurrence gives P_n and P_{n−1}.
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
    rule.points[i] = x;
    rule.weights[i] = (1 - x * x) * slope * slope;
  }
  return rule;
}

/// roots(), computed once for the rules of usual elements.
const QuadratureRule& known_roots(int n) {
  static const std::vector<QuadratureRule> known = [] {
    std::vector<QuadratureRule> rules(1);
    for (int count = 1; count <= most_known; ++count) rules.push_back(roots(count));
    return rules;
  }();
  return known[n];
}

} // namespace

QuadratureRule gauss_legendre(int n, double a, double b) {
  require(n >= 1, "solid.quadrature.points", {{"count", n}});
  QuadratureRule rule = n <= most_known ? known_roots(n) : roots(n);
  for (int i = 0; i < n; ++i) {
    rule.points[i] = 0.5 * (a + b) + 0.5 * (b - a) * rule.points[i];
    // w_i = 2 / ((1 − x²) P_n'²), times (b − a) / 2
    rule.weights[i] = (b - a) / rule.weights[i];
  }
  return rule;
}

ElementQuadrature tensor_product(const std::vector<QuadratureRule>& rules) {
  int size = 1;
  for (const QuadratureRule& rule : rules) size *= std::ssize(rule.points);
  const int dimensions = std::ssize(rules);
  ElementQuadrature result{MatrixX(dimensions, size), VectorX::Ones(size)};
  for (int q = 0; q < size; ++q)
    for (int d = 0, rest = q; d < dimensions; ++d) {
      const auto& [points, weights] = rules[d];
      const int count = std::ssize(points);
      result.points(d, q) = points[rest % count];
      result.weights(q) *= weights[rest % count];
      rest /= count;
    }
  return result;
}

} // namespace signorini::solid
