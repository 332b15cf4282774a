#include "base/box_least_squares.hpp"
#include "base/dense.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace signorini {
namespace box_least_squares_test {

MatrixX random_matrix(Eigen::Index rows, Eigen::Index columns, std::mt19937& random) {
  std::normal_distribution<double> normal;
  return MatrixX::NullaryExpr(rows, columns, [&] { return normal(random); });
}

// The minimum is where Aᵀ (b − A d) vanishes within the box, and points out of it at its borders.
TEST(BoxLeastSquares, FindsTheMinimumOfRandomProblems) {
  std::mt19937 random(1);
  int bound = 0;
  for (int k = 0; k < 500; ++k) {
    const Eigen::Index n = 1 + k % 8, m = 1 + k % 13; // also with fewer equations than unknowns
    const MatrixX a = random_matrix(m, n, random);
    const VectorX b = 3 * random_matrix(m, 1, random);
    VectorX low = -random_matrix(n, 1, random).cwiseAbs(), high = random_matrix(n, 1, random).cwiseAbs();
    if (k % 3 == 0) low(0) = -std::numeric_limits<double>::infinity();
    if (k % 5 == 0) high(n - 1) = 0;
    const VectorX d = box_least_squares(a, b, low, high), descent = a.transpose() * (b - a * d);
    for (Eigen::Index i = 0; i < n; ++i) {
      EXPECT_GE(d(i), low(i));
      EXPECT_LE(d(i), high(i));
      const double limit = 1e-12 * a.norm() * b.norm();
      EXPECT_TRUE(d(i) == low(i) || descent(i) >= -limit);
      EXPECT_TRUE(d(i) == high(i) || descent(i) <= limit);
      bound += d(i) == low(i) || d(i) == high(i);
    }
  }
  EXPECT_GT(bound, 500);
}

TEST(BoxLeastSquares, LeavesUndeterminedUnknownsAlone) {
  MatrixX a(2, 3);
  a << 1, 0, 1, 0, 0, 0;
  const VectorX far = VectorX::Constant(3, 10), d = box_least_squares(a, VectorX::Ones(2), -far, far);
  EXPECT_LT((d - VectorX::Unit(3, 0) / 2 - VectorX::Unit(3, 2) / 2).norm(), 1e-15);
}

TEST(Dense, SingularValuesMultiplyToTheMatrix) {
  std::mt19937 random(2);
  const MatrixX a = random_matrix(7, 3, random);
  const dense::SingularValues found = dense::singular_values(a);
  EXPECT_LT((found.u * found.values.asDiagonal() * found.v.transpose() - a).norm(), 1e-14 * a.norm());
  EXPECT_GE(found.values(0), found.values(1));
}

} // namespace box_least_squares_test
} // namespace signorini
