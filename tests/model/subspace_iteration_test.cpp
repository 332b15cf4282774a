#include "model/stability/subspace_iteration.hpp"

#include "base/dense.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace signorini::model {
namespace subspace_iteration_test {

constexpr int size = 30;

std::vector<double> values_of(const MatrixX& full) {
  return {full.data(), full.data() + full.size()};
}

/// A dense problem with K = M^½ S M^½ for a given S, whose last unknown has no mass and follows the first one.
Eigenproblem problem_of(const solve::Pattern& pattern, const MatrixX& s, bool symmetric) {
  const VectorX root = VectorX::LinSpaced(size - 1, 1, 3);
  MatrixX stiffness = MatrixX::Zero(size, size), mass = stiffness;
  stiffness.topLeftCorner(size - 1, size - 1) = root.asDiagonal() * s * root.asDiagonal();
  mass.topLeftCorner(size - 1, size - 1) = root.cwiseAbs2().asDiagonal();
  stiffness(0, 0) += 4, stiffness(size - 1, size - 1) = 4, stiffness(0, size - 1) = stiffness(size - 1, 0) = -4;
  return {pattern, values_of(stiffness), values_of(mass), symmetric};
}

solve::Pattern dense_pattern() {
  std::vector<int> all(size);
  std::iota(all.begin(), all.end(), 0);
  return solve::couple(size, {all});
}

MatrixX axes() {
  MatrixX random(size - 1, size - 1);
  for (int i = 0; i < size - 1; ++i)
    for (int j = 0; j < size - 1; ++j) random(i, j) = std::sin(1 + 3 * i + 7 * j + i * j);
  return dense::orthogonal(random);
}

RitzPairs iterate(Eigenproblem problem, double shift, int count) {
  SubspaceIteration iteration(solve::LinearKind::umfpack, std::move(problem), count);
  EXPECT_TRUE(iteration.shift(shift));
  for (int round = 0; round < 40; ++round) EXPECT_TRUE(iteration.advance());
  return iteration.pairs();
}

TEST(SubspaceIteration, FindsTheEigenvaluesNextToAShift) {
  VectorX values = VectorX::LinSpaced(size - 1, 2, 30);
  values(3) = -0.5, values(7) = 0, values(11) = values(12) = 0.7;
  const MatrixX q = axes();
  const solve::Pattern pattern = dense_pattern();
  const RitzPairs pairs = iterate(problem_of(pattern, q * values.asDiagonal() * q.transpose(), true), -1, 10);
  const double expected[] = {-0.5, 0, 0.7, 0.7, 2, 3};
  for (int k = 0; k < 6; ++k) {
    EXPECT_NEAR(pairs.values(k).real(), expected[k], 1e-10);
    EXPECT_LT(pairs.errors(k), 1e-6);
    EXPECT_NEAR(pairs.vectors(size - 1, k), pairs.vectors(0, k), 1e-10); // without mass
  }
}

TEST(SubspaceIteration, FindsComplexEigenvaluesOfAnUnsymmetricMatrix) {
  MatrixX s = VectorX::LinSpaced(size - 1, 2, 30).asDiagonal();
  s.topLeftCorner(2, 2) << 1, 0.5, -0.5, 1; // 1 ± 0.5 i
  s(5, 20) = 8;
  const MatrixX q = axes();
  const solve::Pattern pattern = dense_pattern();
  const RitzPairs pairs = iterate(problem_of(pattern, q * s * q.transpose(), false), 0, 10);
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(pairs.values(k).real(), 1, 1e-10);
    EXPECT_NEAR(std::abs(pairs.values(k).imag()), 0.5, 1e-10);
    EXPECT_LT(pairs.errors(k), 1e-8);
  }
  EXPECT_NEAR(pairs.values(2).real(), 4, 1e-8);
}

} // namespace subspace_iteration_test
} // namespace signorini::model
