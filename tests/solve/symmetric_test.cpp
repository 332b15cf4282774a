// The solvers on symmetric systems, definite or not, and the test of symmetry.
#include "solve/linear.hpp"
#include "solve/values.hpp"

#include "nurbs/random_patch.hpp"
#include "solve/matrices.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace signorini::solve {
namespace symmetric_test {

using namespace test;

/// All unknowns coupled.
Pattern full(int size) {
  std::vector<int> all(size);
  std::iota(all.begin(), all.end(), 0);
  return couple(size, {all});
}

Values random_symmetric(std::mt19937& random, const Pattern& pattern) {
  Values values = random_values(random, pattern);
  for_entries(pattern, [&](int i, int j, int k) {
    if (i < j) values[pattern.find(j, i)] = values[k];
  });
  return values;
}

class Symmetric : public testing::TestWithParam<LinearKind> {};

TEST_P(Symmetric, SolvesDefiniteAndIndefiniteSystemsAlternately) {
  std::mt19937 random(21);
  for (const Pattern& pattern : {chain(1), chain(2), chain(13), chain(120), full(420)}) {
    const auto solver = make_solver(GetParam(), pattern);
    EXPECT_EQ(solver->kind(), GetParam());
    for (double diagonal : {1.0, -1.0, -1.0, 1.0, 1.0}) {
      const Values values = random_definite(random, pattern, diagonal);
      EXPECT_LT(backward_error(*solver, pattern, values), 1e-14) << pattern.size << " " << diagonal;
    }
    for (int round = 0; round < 5; ++round) {
      const Values values = random_symmetric(random, pattern);
      EXPECT_LT(backward_error(*solver, pattern, values), 1e-10) << pattern.size << " " << round;
    }
  }
}

/// A regular matrix with a negligible diagonal.
TEST_P(Symmetric, SolvesMatricesWithNegligibleDiagonal) {
  const Pattern pattern = chain(61);
  std::mt19937 random(22);
  const auto solver = make_solver(GetParam(), pattern);
  for (double diagonal : {1e-9, 1e-15, 0.0}) {
    Values values = random_symmetric(random, pattern);
    for (int i = 0; i < pattern.size; ++i) values[pattern.find(i, i)] = diagonal;
    EXPECT_LT(backward_error(*solver, pattern, values), 1e-10) << diagonal;
  }
}

TEST_P(Symmetric, SingularMatricesAreReportedAndLeaveNoTrace) {
  std::mt19937 random(23);
  auto [pattern, values] = free_springs(random, 50);
  const auto solver = make_solver(GetParam(), pattern);
  for (int round = 0; round < 2; ++round) {
    EXPECT_FALSE(solver->factor(values.data()));
    EXPECT_FALSE(solver->factor(Values(values.size(), 0.0).data()));
    Values supported = values;
    supported[pattern.find(0, 0)] += 1;
    EXPECT_LT(backward_error(*solver, pattern, supported), 1e-14);
  }
}

INSTANTIATE_TEST_SUITE_P(Solvers, Symmetric, testing::ValuesIn(direct_kinds()),
                         [](const auto& info) { return name_of(info.param); });

TEST(Symmetry, ComparesTransposedEntriesRelativeToTheLargest) {
  std::mt19937 random(26);
  for (int size : {1, 2, 13, 60}) {
    const Pattern pattern = chain(size);
    Values values = random_definite(random, pattern);
    const double largest = *std::max_element(values.begin(), values.end());
    EXPECT_TRUE(is_symmetric(pattern, values.data()));
    for_entries(pattern, [&](int i, int j, int k) {
      const double original = values[k];
      values[k] = original + 0.9e-9 * largest;
      EXPECT_TRUE(is_symmetric(pattern, values.data())) << i << " " << j;
      values[k] = original + 1.2e-9 * largest;
      EXPECT_EQ(is_symmetric(pattern, values.data()), i == j) << i << " " << j;
      values[k] = original;
    });
  }
}

TEST(Symmetry, AddsTheTransposedEntries) {
  std::mt19937 random(28);
  for (int size : {1, 2, 13, 60}) {
    const Pattern pattern = chain(size);
    const Values before = random_values(random, pattern);
    Values values = before;
    add_transpose(pattern, values.data());
    const Values half = symmetrized(pattern, before);
    for_entries(pattern, [&](int i, int j, int k) {
      EXPECT_EQ(values[k], before[k] + before[pattern.find(j, i)]) << i << " " << j;
      EXPECT_EQ(half[k], 0.5 * values[k]) << i << " " << j;
    });
  }
}

TEST(RelativeResidual, AgreesWithTheDenseProduct) {
  std::mt19937 random(27);
  const Pattern pattern = chain(30);
  const Values values = random_values(random, pattern);
  const Eigen::VectorXd x = Eigen::VectorXd::Random(30), b = Eigen::VectorXd::Random(30);
  std::vector<double> scratch;
  EXPECT_NEAR(relative_residual(pattern, values.data(), x.data(), b.data(), scratch),
              (b - dense(pattern, values) * x).norm() / b.norm(), 1e-13);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(30);
  EXPECT_EQ(relative_residual(pattern, values.data(), x.data(), none.data(), scratch), 0);
  const Eigen::VectorXd broken = Eigen::VectorXd::Constant(30, std::nan(""));
  EXPECT_TRUE(std::isinf(relative_residual(pattern, values.data(), broken.data(), b.data(), scratch)));
}

} // namespace symmetric_test
} // namespace signorini::solve
