// The direct solvers on random unsymmetric systems with the same pattern.
#include "solve/linear.hpp"

#include "nurbs/random_patch.hpp"
#include "solve/matrices.hpp"

#include <gtest/gtest.h>

namespace signorini::solve {
namespace linear_test {

using namespace test;

class Linear : public testing::TestWithParam<LinearKind> {};

TEST_P(Linear, SolvesSeveralSystemsWithOnePattern) {
  std::mt19937 random(3);
  for (int size : {1, 2, 13, 120, 400}) {
    const Pattern pattern = chain(size);
    const auto solver = make_solver(GetParam(), pattern);
    EXPECT_EQ(solver->kind(), GetParam());
    for (int round = 0; round < 10; ++round)
      EXPECT_LT(backward_error(*solver, pattern, random_values(random, pattern)), 1e-12) << size << " " << round;
  }
}

/// Formerly large pivots vanish: a factorization that reused them would lose all digits.
TEST_P(Linear, SolvesValuesThatNeedOtherPivots) {
  std::mt19937 random(4);
  const Pattern pattern = chain(100);
  const auto solver = make_solver(GetParam(), pattern);
  Values values = random_values(random, pattern);
  for (int i = 0; i < pattern.size; ++i) values[pattern.find(i, i)] = 50;
  EXPECT_LT(backward_error(*solver, pattern, values), 1e-14);
  for (double diagonal : {1e-3, 1e-9, 1e-15, 0.0}) {
    for (int i = 0; i < pattern.size; ++i) values[pattern.find(i, i)] = diagonal;
    EXPECT_LT(backward_error(*solver, pattern, values), 1e-12) << "diagonal " << diagonal;
  }
}

TEST_P(Linear, SingularMatricesAreReportedAndLeaveNoTrace) {
  std::mt19937 random(5);
  const Pattern pattern = chain(40);
  const auto solver = make_solver(GetParam(), pattern);
  const Values good = random_values(random, pattern);
  for (bool factored_before : {false, true}) {
    Values singular = good;
    for (int j = 0; j < pattern.size; ++j)
      if (const int k = pattern.find(5, j); k >= 0) singular[k] = 0;
    EXPECT_FALSE(solver->factor(singular.data())) << "factored before: " << factored_before;
    EXPECT_FALSE(solver->factor(Values(good.size(), 0.0).data()));
    EXPECT_LT(backward_error(*solver, pattern, good), 1e-12);
  }
}

/// KLU's pivots show whether a symmetric matrix is positive definite, also where it reuses the former ones.
TEST(Klu, KnowsDefiniteMatrices) {
  std::mt19937 random(7);
  const auto springs = free_springs(random, 30);
  const Pattern& pattern = springs.first;
  const Values& values = springs.second;
  const auto solver = make_solver(LinearKind::klu, pattern);
  const auto judged = [&](double shift) {
    Values shifted = values;
    for (int i = 0; i < pattern.size; ++i) shifted[pattern.find(i, i)] += shift;
    EXPECT_TRUE(solver->factor(shifted.data()));
    return solver->statistics().definite;
  };
  EXPECT_TRUE(judged(1e-3)); // of springs the least eigenvalue is 0
  EXPECT_TRUE(judged(1));
  EXPECT_FALSE(judged(-1e-3));
  EXPECT_FALSE(judged(-100));
  EXPECT_TRUE(judged(1e-3));
}

/// An unconstrained chain of springs: the last pivot is zero up to rounding error.
TEST_P(Linear, SingularityToWorkingPrecisionIsReported) {
  std::mt19937 random(6);
  auto [pattern, values] = free_springs(random, 30);
  const auto solver = make_solver(GetParam(), pattern);
  EXPECT_FALSE(solver->factor(values.data()));
  values[pattern.find(0, 0)] += 1e-6;
  EXPECT_TRUE(solver->factor(values.data()));
}

/// Pattern, values and right-hand side may be destroyed, and a pattern may follow another one.
TEST(DirectSolvers, CopyWhatTheyNeed) {
  std::mt19937 random(7);
  for (const MakeDirect& make : {MakeDirect(make_klu), MakeDirect(make_umfpack)}) {
    const auto solver = make();
    for (int size : {50, 20, 80}) {
      const Pattern pattern = chain(size);
      solver->analyze(Pattern(pattern));
      for (int round = 0; round < 3; ++round) { // KLU reuses its pivots in the second and checks the solution
        const Values values = random_definite(random, pattern);
        Values passing = values;
        ASSERT_TRUE(solver->factor(passing.data()));
        std::fill(passing.begin(), passing.end(), std::nan(""));
        const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(size, -1, 2);
        Eigen::VectorXd x = b;
        ASSERT_TRUE(solver->solve(x.data()));
        EXPECT_LT((product(pattern, values, x) - b).norm(), 1e-12 * b.norm());
        // Pivots of a diagonally dominant matrix lie in its Gershgorin circles.
        const PivotRange pivots = solver->pivots();
        EXPECT_GE(pivots.least, 0.1 * (1 - 1e-12));
        EXPECT_LE(pivots.largest, 2 * dense(pattern, values).diagonal().maxCoeff());
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Solvers, Linear, testing::ValuesIn(direct_kinds()),
                         [](const auto& info) { return name_of(info.param); });

/// Two unknowns per node on a grid of nodes, coupled over one element.
Pattern grid(int columns, int rows) {
  std::vector<std::vector<int>> groups;
  for (int j = 0; j + 1 < rows; ++j)
    for (int i = 0; i + 1 < columns; ++i) {
      std::vector<int> group;
      for (int node : {i + columns * j, i + 1 + columns * j, i + columns * (j + 1), i + 1 + columns * (j + 1)})
        group.insert(group.end(), {2 * node, 2 * node + 1});
      groups.push_back(group);
    }
  return couple(2 * columns * rows, groups);
}

TEST(LinearKinds, ReuseExpensiveFactorizations) {
  std::mt19937 random(49);
  const auto choice = [&](const Pattern& pattern) {
    const auto solver = make_solver(LinearKind::automatic, pattern);
    for (int round = 0; round < 3; ++round) {
      const Values values = random_definite(random, pattern);
      EXPECT_LT(backward_error(*solver, pattern, values), 1e-3);
    }
    EXPECT_EQ(solver->statistics().solutions, 6);
    return solver->kind();
  };
  EXPECT_EQ(choice(chain(100)), LinearKind::klu);
  EXPECT_EQ(choice(grid(200, 8)), LinearKind::klu); // long and narrow
  EXPECT_EQ(choice(grid(120, 120)), LinearKind::reuse);
  EXPECT_EQ(choice(cube(9)), LinearKind::reuse);
  EXPECT_EQ(choice(cube(11)), LinearKind::reuse);
}

TEST(LinearKinds, HaveNames) {
  for (LinearKind kind : {LinearKind::automatic, LinearKind::klu, LinearKind::umfpack, LinearKind::condensed,
                          LinearKind::reuse, LinearKind::mumps})
    EXPECT_EQ(linear_kind(name_of(kind)), kind);
  EXPECT_ERROR(linear_kind("pardiso"),
               "solve.linear.unknown: name = pardiso, known = (auto, klu, umfpack, condensed, reuse, mumps)");
  EXPECT_EQ(make_solver(LinearKind::automatic, chain(10))->kind(), LinearKind::klu);
}

TEST(PivotRange, RecognizesSingularAndNonfinitePivots) {
  PivotRange pivots;
  EXPECT_TRUE(pivots.regular()); // without unknowns
  for (double pivot : {2.0, -1e-13, 7.0}) pivots.add(pivot);
  EXPECT_TRUE(pivots.regular());
  PivotRange wide = pivots;
  wide.add(1e3);
  EXPECT_FALSE(wide.regular());
  PivotRange joined;
  joined.add(wide);
  EXPECT_FALSE(joined.regular());
  for (double bad : {0.0, std::nan(""), HUGE_VAL}) {
    PivotRange copy = pivots;
    copy.add(bad);
    copy.add(1.0);
    EXPECT_FALSE(copy.regular()) << bad;
  }
}

} // namespace linear_test
} // namespace signorini::solve
