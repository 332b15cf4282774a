#pragma once
// Length, area or volume of a patch by quadrature of its Jacobian.

#include "nurbs/patch.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace signorini::nurbs::test {

struct Measure {
  double content = 0;                                     ///< length, area or volume
  double least = std::numeric_limits<double>::infinity(); ///< least Jacobian at the quadrature points
  VectorX centroid;                                       ///< center of mass
};

/// Gauss–Legendre nodes and weights on [0, 1] by Newton's method on the Legendre polynomial.
inline std::vector<std::array<double, 2>> gauss(int n) {
  std::vector<std::array<double, 2>> rule;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), slope = 1;
    for (int step = 0; step < 50; ++step) {
      double value = x, before = 1;
      for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
      }
      slope = n * (x * value - before) / (x * x - 1);
      x -= value / slope;
    }
    rule.push_back({(1 + x) / 2, 1 / ((1 - x * x) * slope * slope)});
  }
  return rule;
}

/// `points` Gauss points per element and direction. The Jacobian is signed if the patch fills the space.
inline Measure measure(const Patch& patch, int points = 12) {
  const auto rule = gauss(points);
  const int dimensions = patch.parametric_dimension();
  int total = 1;
  for (int d = 0; d < dimensions; ++d) total *= patch.direction(d).elements() * points;
  Measure result;
  result.centroid = VectorX::Zero(patch.dimension());
  for (int n = 0; n < total; ++n) {
    VectorX xi(dimensions);
    double weight = 1;
    for (int d = 0, rest = n; d < dimensions; ++d) {
      const auto& breaks = patch.direction(d).breaks();
      const int count = patch.direction(d).elements() * points, i = rest % count;
      rest /= count;
      const std::size_t e = static_cast<std::size_t>(i / points), g = static_cast<std::size_t>(i % points);
      xi(d) = breaks[e] + (breaks[e + 1] - breaks[e]) * rule[g][0];
      weight *= (breaks[e + 1] - breaks[e]) * rule[g][1];
    }
    const auto all = derivatives(patch, xi, 1);
    MatrixX jacobian(patch.dimension(), dimensions);
    for (int d = 0; d < dimensions; ++d) jacobian.col(d) = all[static_cast<std::size_t>(d) + 1].value;
    const double j = dimensions == patch.dimension() ? jacobian.determinant()
                                                     : std::sqrt((jacobian.transpose() * jacobian).determinant());
    result.least = std::min(result.least, j);
    result.content += weight * j;
    result.centroid += weight * j * all[0].value;
  }
  result.centroid /= result.content;
  return result;
}

} // namespace signorini::nurbs::test
