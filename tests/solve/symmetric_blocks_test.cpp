// Matrices of small blocks compared with dense ones.
#include "solve/symmetric_blocks.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <numeric>
#include <random>

namespace signorini::solve {
namespace symmetric_blocks_test {

template <int D> void expect_dense(int nodes, int count, std::mt19937& random) {
  std::vector<std::vector<int>> groups;
  for (int g = 0; g < count; ++g) {
    std::vector<int> all(static_cast<std::size_t>(nodes));
    std::iota(all.begin(), all.end(), 0);
    std::shuffle(all.begin(), all.end(), random); // in any order
    all.resize(static_cast<std::size_t>(std::min(nodes, 1 + g % 5)));
    groups.push_back(all);
  }
  SymmetricBlocks<D> matrix(nodes, groups);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(D * nodes, D * nodes);
  for (const auto& group : groups) {
    const int n = std::ssize(group);
    const Eigen::MatrixXd random_values = Eigen::MatrixXd::Random(D * n, D * n),
                          own = random_values + random_values.transpose();
    std::vector<double> blocks;
    for (int i = 0; i < D; ++i)
      for (int j = i; j < D; ++j)
        for (int a = 0; a < n; ++a)
          for (int b = 0; b < n; ++b) blocks.push_back(own(D * a + i, D * b + j));
    matrix.add(group, blocks.data());
    std::vector<int> dofs;
    for (int node : group)
      for (int i = 0; i < D; ++i) dofs.push_back(D * node + i);
    dense(dofs, dofs) += own;
  }
  const Eigen::VectorXd x = Eigen::VectorXd::Random(D * nodes), before = Eigen::VectorXd::Random(D * nodes);
  Eigen::VectorXd y = before;
  matrix.multiply(x.data(), y.data());
  EXPECT_LT((y - before - dense * x).norm(), 1e-13 * (1 + dense.norm() * x.norm()));
  Eigen::MatrixXd upper = Eigen::MatrixXd::Zero(D * nodes, D * nodes);
  matrix.visit_upper([&](int row, int column, int length, const double* values) {
    EXPECT_GE(column / D, row / D);
    for (int k = 0; k < length; ++k) upper(row, column + k) += values[k];
  });
  EXPECT_LT((upper + upper.transpose() - dense).norm(), 1e-14 * (1 + dense.norm()));
}

TEST(SymmetricBlocks, AreTheSumOfTheGroupsMatrices) {
  std::mt19937 random(3);
  for (int nodes : {1, 2, 7, 30})
    for (int count : {0, 1, 4, 40}) {
      expect_dense<2>(nodes, count, random);
      expect_dense<3>(nodes, count, random);
    }
}

} // namespace symmetric_blocks_test
} // namespace signorini::solve
