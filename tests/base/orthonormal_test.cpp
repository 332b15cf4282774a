#include "base/orthonormal.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini {
namespace orthonormal_test {

MatrixX some(int rows, int columns) {
  MatrixX x(rows, columns);
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < rows; ++i) x(i, j) = std::sin(1.0 + 0.7 * (i + 1) * (j + 1) + 0.01 * i * i);
  return x;
}

TEST(Orthonormal, ColumnsSpanTheInput) {
  MatrixX x = some(20, 5);
  x.col(3) = x.col(1) + 1e-9 * x.col(3); // nearly dependent
  const MatrixX q = orthonormal(x);
  EXPECT_LT((q.transpose() * q - MatrixX::Identity(5, 5)).norm(), 1e-14);
  EXPECT_LT(residual_of(q, x).norm(), 1e-14 * x.norm());
}

TEST(Orthonormal, PseudoInverseInvertsAndFits) {
  const MatrixX square = some(5, 5), tall = some(20, 5), inverse = pseudo_inverse(tall);
  EXPECT_LT((pseudo_inverse(square) * square - MatrixX::Identity(5, 5)).norm(), 1e-10);
  EXPECT_LT((inverse * tall - MatrixX::Identity(5, 5)).norm(), 1e-10);
  EXPECT_LT((tall * inverse - (tall * inverse).transpose()).norm(), 1e-10); // an orthogonal projection
}

TEST(Orthonormal, DependentColumnsStayOrthogonalAndZeroStaysZero) {
  MatrixX x = some(20, 4);
  x.col(2) = 3 * x.col(0) - x.col(1);
  x.col(3).setZero();
  const MatrixX q = orthonormal(x);
  EXPECT_LT((q.leftCols(3).transpose() * q.leftCols(3) - MatrixX::Identity(3, 3)).norm(), 1e-14);
  EXPECT_EQ(q.col(3).norm(), 0);
}

TEST(Orthonormal, ResidualIsThatOfLeastSquares) {
  const MatrixX x = some(12, 3), b = some(12, 5).rightCols(2);
  const MatrixX expected = b - x * (x.transpose() * x).inverse() * x.transpose() * b;
  EXPECT_LT((residual_of(orthonormal(x), b) - expected).norm(), 1e-10 * b.norm());
}

} // namespace orthonormal_test
} // namespace signorini
