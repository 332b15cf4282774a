#include "solid/quadrature.hpp"

#include "nurbs/plan.hpp"
#include "nurbs/random_patch.hpp"
#include "nurbs/shapes.hpp"
#include "solid/body.hpp"
#include "solid/neo_hookean.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace signorini::solid {
namespace quadrature_test {

TEST(Quadrature, ExactUpToDegree2nMinus1AndNotBeyond) {
  for (int n = 1; n <= 48; ++n) {
    const double a = -0.4, b = 1.0;
    const QuadratureRule rule = gauss_legendre(n, a, b);
    ASSERT_EQ(rule.points.size(), static_cast<std::size_t>(n));
    const auto integrate = [&](int degree) {
      double sum = 0;
      for (std::size_t i = 0; i < rule.points.size(); ++i) sum += rule.weights[i] * std::pow(rule.points[i], degree);
      return sum;
    };
    const auto exact = [&](int degree) { return (std::pow(b, degree + 1) - std::pow(a, degree + 1)) / (degree + 1); };
    for (int degree = 0; degree < 2 * n; ++degree)
      EXPECT_NEAR(integrate(degree), exact(degree), 1e-14 * (b - a)) << n << " points, degree " << degree;
    if (n <= 5) {
      EXPECT_GT(std::abs(integrate(2 * n) - exact(2 * n)), 1e-6) << n << " points";
    }
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      EXPECT_GT(rule.weights[i], 0);
      EXPECT_GT(rule.points[i], i == 0 ? a : rule.points[i - 1]);
      EXPECT_LT(rule.points[i], b);
    }
  }
}

TEST(Quadrature, RuleWithoutPointsIsAnError) {
  EXPECT_ERROR(gauss_legendre(0, 0, 1), "solid.quadrature.points: count = 0");
}

TEST(Quadrature, WeightsOfABodyAddUpToItsVolume) {
  const Body<2> ring(nurbs::Discretization(nurbs::half_annulus(0.3, 0.5, Eigen::Vector2d(1, 2)),
                                           nurbs::test::plan_of({6, 4}, "south", "N2-N2.2", 1)),
                     neo_hookean(1, 0.3));
  double area = 0;
  for (int e = 0; e < ring.elements(); ++e)
    area = std::accumulate(ring.tables().weights_of(e), ring.tables().weights_of(e) + ring.tables().element(e).points,
                           area);
  EXPECT_NEAR(area, std::acos(-1.0) / 2 * (0.25 - 0.09), 1e-7);
}

} // namespace quadrature_test
} // namespace signorini::solid
