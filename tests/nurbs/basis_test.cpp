#include "nurbs/basis.hpp"

#include "random_patch.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::nurbs {
namespace basis_test {

using namespace test;

TEST(Basis, AgreesWithTheRecursionAndItsDerivatives) {
  Random random(1);
  for (int run = 0; run < 60; ++run) {
    const KnotVector knots = random_knots(random, run % 7, integer(random, 0, 4));
    const int p = knots.degree(), order = p + 2;
    std::vector<double> out((order + 1) * (p + 1), 99.0);
    const double xi = run % 10 == 0 ? knots.last() : uniform(random, -1, 3);
    const int element = knots.find_element(xi), first = knots.first_function(element);
    basis_derivatives(knots, element, xi, order, out.data());
    for (int k = 0; k <= order; ++k) {
      double scale = 1;
      for (int s = 0; s <= p; ++s) scale = std::max(scale, std::abs(out[k * (p + 1) + s]));
      for (int i = 0; i < knots.functions(); ++i) {
        const bool local = i >= first && i <= first + p;
        const double value = local ? out[k * (p + 1) + i - first] : 0;
        EXPECT_NEAR(value, cox_de_boor(knots, i, p, xi, k), 1e-12 * scale) << "degree " << p << ", function " << i;
        if (k > p) {
          EXPECT_EQ(value, 0);
        }
      }
    }
  }
}

TEST(Basis, IsAPartitionOfUnityUpToTheHighestDegree) {
  Random random(2);
  for (int p = 0; p <= max_degree; ++p) {
    const KnotVector knots = random_knots(random, p, 3);
    std::vector<double> out(3 * (p + 1));
    const double xi = uniform(random, -1, 3);
    basis_derivatives(knots, knots.find_element(xi), xi, 2, out.data());
    double sums[3] = {0, 0, 0}, sizes[3] = {1, 1, 1};
    for (int k = 0; k < 3; ++k)
      for (int s = 0; s <= p; ++s) {
        sums[k] += out[k * (p + 1) + s];
        sizes[k] += std::abs(out[k * (p + 1) + s]);
        if (k == 0) {
          EXPECT_GE(out[s], 0);
        }
      }
    EXPECT_NEAR(sums[0], 1, 1e-14);
    EXPECT_NEAR(sums[1], 0, 1e-14 * sizes[1]);
    EXPECT_NEAR(sums[2], 0, 1e-14 * sizes[2]);
  }
}

TEST(Basis, ContinuesTheElementPolynomialOutside) {
  // A cubic is determined by four values: Lagrange extrapolation gives the polynomial outside.
  const KnotVector knots(3, {0, 0, 0, 0, 1, 2.5, 2.5, 4, 4, 4, 4});
  double out[4];
  const double nodes[] = {1.1, 1.5, 2.0, 2.4}, outside[] = {0.7, 2.5, 3.0};
  double values[4][4];
  for (int n = 0; n < 4; ++n) basis_derivatives(knots, 1, nodes[n], 0, values[n]);
  for (double xi : outside) {
    basis_derivatives(knots, 1, xi, 0, out);
    for (int s = 0; s < 4; ++s) {
      double expected = 0;
      for (int n = 0; n < 4; ++n) {
        double lagrange = 1;
        for (int m = 0; m < 4; ++m)
          if (m != n) lagrange *= (xi - nodes[m]) / (nodes[n] - nodes[m]);
        expected += lagrange * values[n][s];
      }
      EXPECT_NEAR(out[s], expected, 1e-13);
    }
  }
}

TEST(Basis, BernsteinPolynomialsInClosedForm) {
  // B_{s,4}(ξ) = C(4,s) ξ^s (1−ξ)^{4−s}
  const KnotVector knots = KnotVector::single(4);
  const double binomials[] = {1, 4, 6, 4, 1};
  for (double xi : {0.0, 0.2, 0.5, 1.0}) {
    double out[5];
    basis_derivatives(knots, 0, xi, 0, out);
    for (int s = 0; s <= 4; ++s) EXPECT_NEAR(out[s], binomials[s] * std::pow(xi, s) * std::pow(1 - xi, 4 - s), 1e-15);
  }
}

} // namespace basis_test
} // namespace signorini::nurbs
