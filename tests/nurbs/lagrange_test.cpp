// Lp elements interpolate: exact at their nodes, and the geometry's error converges with order p+1.
#include "nurbs/lagrange.hpp"

#include "nurbs/discretization.hpp"
#include "nurbs/plan.hpp"
#include "nurbs/random_patch.hpp"
#include "nurbs/shapes.hpp"

#include <gtest/gtest.h>

namespace signorini::nurbs {
namespace lagrange_test {

TEST(Lagrange, InterpolatesThePatchAtItsNodes) {
  test::Random random(11);
  for (int dimensions : {1, 2, 3})
    for (int trial = 0; trial < 6; ++trial) {
      const Patch patch = test::random_patch(random, dimensions, dimensions == 1 ? 2 : dimensions, 3);
      std::vector<int> degrees;
      std::vector<std::vector<double>> breaks;
      for (int d = 0; d < dimensions; ++d) {
        degrees.push_back(test::integer(random, 1, 4));
        breaks.push_back(patch.direction(d).breaks());
      }
      const Patch lagrange = interpolate_lagrange(patch, degrees, breaks);
      EXPECT_TRUE((lagrange.weights().array() == 1).all());
      for (int d = 0; d < dimensions; ++d) {
        EXPECT_EQ(lagrange.direction(d).breaks(), patch.direction(d).breaks());
        EXPECT_EQ(lagrange.direction(d).functions(), degrees[d] * patch.direction(d).elements() + 1);
      }
      for (int n = 0; n < 40; ++n) {
        VectorX xi(dimensions);
        for (int d = 0; d < dimensions; ++d) {
          const int e = test::integer(random, 0, patch.direction(d).elements() - 1);
          const auto& knots = patch.direction(d).breaks();
          const double a = knots[e], b = knots[static_cast<std::size_t>(e) + 1];
          const int p = degrees[d], k = test::integer(random, 0, p);
          xi(d) = k == p ? b : a + (b - a) * k / p;
        }
        EXPECT_NEAR((evaluate(lagrange, xi) - evaluate(patch, xi)).norm(), 0, 1e-13);
      }
    }
}

double geometry_error(int p, int elements) {
  const Patch arc = half_annulus(0.3, 0.5, Eigen::Vector2d(0.75, 1.5));
  const Plan plan = test::plan_of({elements, 1}, "south", text("L", p), 1);
  const Row face = Discretization(arc, plan).face(plan.contact.front());
  double largest = 0;
  for (int k = 0; k <= 1000; ++k) {
    const double xi = k / 1000.0;
    largest =
        std::max(largest, (evaluate(face, VectorX::Constant(1, xi)) - evaluate(arc, Eigen::Vector2d(xi, 0))).norm());
  }
  return largest;
}

TEST(Lagrange, GeometryErrorConvergesWithOrderPPlusOne) {
  for (int p = 1; p <= 4; ++p) {
    const double rate = std::log2(geometry_error(p, 16) / geometry_error(p, 32));
    EXPECT_NEAR(rate, p + 1, 0.25) << "degree " << p;
  }
}

TEST(Lagrange, LabelWithoutContactFaceAppliesInBothDirections) {
  Plan plan;
  plan.elements = {3, 2};
  plan.labels = {parse_label("L2"), parse_label("L2")};
  const Discretization space(rectangle(3, 1, Eigen::Vector2d(0, 0)), plan);
  EXPECT_EQ(space.functions(), 7 * 5);
}

} // namespace lagrange_test
} // namespace signorini::nurbs
