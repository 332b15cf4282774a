// GMRES compared with the dense least-squares problem that it solves, and its matrix products.
#include "solve/gmres.hpp"

#include "base/dense.hpp"
#include "os/parallel.hpp"
#include "solve/columns.hpp"
#include "solve/matrices.hpp"

#include <gtest/gtest.h>

namespace signorini::solve {
namespace gmres_test {

using namespace test;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd random_matrix(std::mt19937& random, int size) {
  std::uniform_real_distribution<double> number(-1, 1);
  return MatrixXd::NullaryExpr(size, size, [&] { return number(random); });
}

/// Minimum of ‖b − K x‖ / ‖b‖ over x = M⁻¹ span{b, K M⁻¹ b, …} of `dimensions` vectors.
double least_residual(const MatrixXd& k, const MatrixXd& inverse, const VectorXd& b, int dimensions) {
  MatrixXd basis(b.size(), dimensions);
  VectorXd next = b;
  for (int i = 0; i < dimensions; ++i) {
    for (int j = 0; j < i; ++j) next -= basis.col(j).dot(next) * basis.col(j);
    basis.col(i) = next.normalized();
    next = k * (inverse * basis.col(i));
  }
  const MatrixXd images = k * inverse * basis;
  return (b - images * dense::least_squares(images, b).col(0)).norm() / b.norm();
}

TEST(Gmres, ReachesTheLeastResidualAtEveryIteration) {
  std::mt19937 random(31);
  for (int size : {1, 2, 7, 20})
    for (double preconditioned : {0.0, 0.3}) {
      const MatrixXd k = random_matrix(random, size) + 3 * MatrixXd::Identity(size, size);
      const MatrixXd inverse = preconditioned == 0
                                   ? MatrixXd::Identity(size, size)
                                   : MatrixXd((k + preconditioned * random_matrix(random, size)).inverse());
      const VectorXd b = random_matrix(random, size).col(0);
      Gmres gmres(size, size);
      for (int most = 1; most <= size; ++most) {
        VectorXd x;
        const KrylovReport report =
            gmres([&](const double* from,
                      double* to) { Eigen::Map<VectorXd>(to, size) = k * Eigen::Map<const VectorXd>(from, size); },
                  [&](double* z) {
                    const VectorXd image = inverse * Eigen::Map<VectorXd>(z, size);
                    Eigen::Map<VectorXd>(z, size) = image;
                    return true;
                  },
                  b, 1e-13, most, x);
        EXPECT_NEAR((b - k * x).norm() / b.norm(), report.reduction, 1e-12);
        if (report.iterations < most) {
          EXPECT_LE(report.reduction, 1e-13);
          break;
        }
        EXPECT_NEAR(report.reduction, least_residual(k, inverse, b, most), 1e-10) << size << " " << most;
        if (most == size) {
          EXPECT_LT(report.reduction, 1e-12);
        }
      }
    }
}

TEST(Gmres, StopsAsSoonAsTheToleranceIsMet) {
  std::mt19937 random(32);
  const int size = 60;
  const MatrixXd k = 0.05 * random_matrix(random, size) + MatrixXd::Identity(size, size);
  const VectorXd b = VectorXd::Ones(size);
  Gmres gmres(size, size);
  const auto apply = [&](const double* from, double* to) {
    Eigen::Map<VectorXd>(to, size) = k * Eigen::Map<const VectorXd>(from, size);
  };
  const auto nothing = [](double*) { return true; };
  for (double tolerance : {1e-1, 1e-4, 1e-9}) {
    VectorXd x;
    const KrylovReport report = gmres(apply, nothing, b, tolerance, size, x);
    EXPECT_LE((b - k * x).norm(), 1.0001 * tolerance * b.norm());
    EXPECT_GT(least_residual(k, MatrixXd::Identity(size, size), b, report.iterations - 1), tolerance);
  }
}

TEST(Gmres, ReportsSystemsWithoutSolution) {
  const int size = 5;
  const VectorXd b = VectorXd::Ones(size);
  const auto copy = [&](const double* from, double* to) { std::copy_n(from, size, to); };
  const auto zero = [&](const double*, double* to) { std::fill_n(to, size, 0.0); };
  const auto nan = [&](const double*, double* to) { std::fill_n(to, size, std::nan("")); };
  const auto good = [](double*) { return true; };
  const auto bad = [](double*) { return false; };
  Gmres gmres(size, size);
  VectorXd x;
  EXPECT_EQ(gmres(copy, good, b, 1e-10, size, x).iterations, 1);
  EXPECT_TRUE(std::isinf(gmres(zero, good, b, 1e-10, size, x).reduction));
  EXPECT_TRUE(std::isinf(gmres(nan, good, b, 1e-10, size, x).reduction));
  EXPECT_TRUE(std::isinf(gmres(copy, bad, b, 1e-10, size, x).reduction));
}

TEST(ColumnMatrix, ProductsAreBitwiseIdenticalForAnyNumberOfThreads) {
  std::mt19937 random(33);
  for (const Pattern& pattern : {chain(1), chain(2), chain(13), chain(120), cube(5), cube(25)}) {
    const int size = pattern.size;
    const Values values = random_values(random, pattern);
    const VectorXd x = VectorXd::LinSpaced(size, -1, 2);
    ColumnMatrix matrix(pattern);
    matrix.set(values.data());
    VectorXd one(size), two(size);
    matrix.multiply(x.data(), one.data());
    set_worker_threads(2);
    matrix.multiply(x.data(), two.data());
    set_worker_threads(1);
    EXPECT_EQ(one, two);
    EXPECT_LT((one - product(pattern, values, x)).norm(), 1e-14 * (1 + one.norm()));
  }
}

} // namespace gmres_test
} // namespace signorini::solve
