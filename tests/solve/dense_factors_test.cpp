// LU of dense matrices: residuals, pivots, singular matrices, threads.
#include "solve/dense_factors.hpp"

#include "os/parallel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace signorini::solve {
namespace dense_factors_test {

/// A matrix with a zero diagonal, which needs exchanges of rows.
template <class Real> DenseMatrix<Real> random_matrix(int size) {
  std::mt19937 random(static_cast<unsigned>(size));
  std::uniform_real_distribution<double> entry(-1, 1);
  DenseMatrix<Real> a(size, size);
  for (int j = 0; j < size; ++j)
    for (int i = 0; i < size; ++i) a(i, j) = static_cast<Real>(i == j && size > 1 ? 0 : entry(random));
  return a;
}

template <class Real> class DenseFactors : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(DenseFactors, Reals);

TYPED_TEST(DenseFactors, Solve) {
  for (int size : {1, 2, 95, 383, 384, 385, 500, 576}) { // around the least size that threads share, and its panels
    const DenseMatrix<TypeParam> a = random_matrix<TypeParam>(size);
    DenseMatrix<TypeParam> factors = a;
    std::vector<int> exchanges;
    ASSERT_TRUE(factor_dense(factors, exchanges)) << size;
    const VectorX b = VectorX::LinSpaced(size, -1, 2);
    VectorX x = b;
    solve_dense<TypeParam>(factors, exchanges, x);
    // The backward error of Gaussian elimination with row pivoting, with a wide margin for growth of the pivots
    const MatrixX exact = a.template cast<double>();
    const double scale =
        exact.cwiseAbs().rowwise().sum().maxCoeff() * x.cwiseAbs().maxCoeff() + b.cwiseAbs().maxCoeff();
    EXPECT_LT((exact * x - b).cwiseAbs().maxCoeff() / scale, 50 * std::numeric_limits<TypeParam>::epsilon()) << size;
  }
}

TYPED_TEST(DenseFactors, HaveTheSameBitsForAnyNumberOfThreads) {
  DenseMatrix<TypeParam> one = random_matrix<TypeParam>(700), three = one;
  std::vector<int> exchanges_of_one, exchanges_of_three;
  ASSERT_TRUE(factor_dense(one, exchanges_of_one));
  set_worker_threads(3);
  ASSERT_TRUE(factor_dense(three, exchanges_of_three));
  set_worker_threads(1);
  EXPECT_TRUE(one == three);
  EXPECT_EQ(exchanges_of_one, exchanges_of_three);
}

TYPED_TEST(DenseFactors, AreRefusedForSingularMatrices) {
  for (int size : {3, 450}) {
    DenseMatrix<TypeParam> a = random_matrix<TypeParam>(size);
    a.col(size / 3).setZero();
    std::vector<int> exchanges;
    EXPECT_FALSE(factor_dense(a, exchanges)) << size;
  }
}

} // namespace dense_factors_test
} // namespace signorini::solve
