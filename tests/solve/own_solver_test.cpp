// A direct solver outside the project works wherever the project's solvers do.
#include "solve/condensed.hpp"
#include "solve/reused.hpp"

#include "solve/matrices.hpp"

#include <Eigen/SparseLU>
#include <gtest/gtest.h>

namespace signorini::solve {
namespace own_solver_test {

using namespace test;
using Eigen::VectorXd;

/// Eigen's SparseLU, without statistics of its cost.
class OwnSolver final : public DirectSolver {
public:
  void analyze(const Pattern& pattern) override {
    matrix_.resize(pattern.size, pattern.size);
    matrix_.resizeNonZeros(pattern.entries());
    std::copy(pattern.starts.begin(), pattern.starts.end(), matrix_.outerIndexPtr());
    std::copy(pattern.rows.begin(), pattern.rows.end(), matrix_.innerIndexPtr());
    std::fill_n(matrix_.valuePtr(), pattern.entries(), 1.0);
    solver_.analyzePattern(matrix_);
  }
  bool factor(const double* values) override {
    std::copy_n(values, matrix_.nonZeros(), matrix_.valuePtr());
    solver_.factorize(matrix_);
    ++statistics_.factorizations;
    return solver_.info() == Eigen::Success;
  }
  bool solve(double* b) override {
    ++statistics_.solutions;
    Eigen::Map<VectorXd> right(b, matrix_.rows());
    right = solver_.solve(VectorXd(right));
    return right.allFinite();
  }
  PivotRange pivots() const override { return {}; }
  SolverStatistics statistics() const override { return statistics_; }

private:
  Eigen::SparseMatrix<double> matrix_;
  Eigen::SparseLU<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> solver_;
  SolverStatistics statistics_;
};

TEST(OwnSolver, IsReused) {
  std::mt19937 random(54);
  Drift drift(random, cube(6), 10);
  const auto solver = make_reused(drift.pattern, [] { return std::make_unique<OwnSolver>(); });
  const int rounds = 40;
  for (int time = 0; time < rounds; ++time) {
    const Values values = drift.at_time(time);
    const VectorXd b = VectorXd::LinSpaced(drift.pattern.size, time % 3 - 1, 2);
    ASSERT_TRUE(solver->factor(values.data()));
    for (double promised : {loosest_tolerance, tightest_tolerance}) {
      VectorXd x = b;
      ASSERT_TRUE(solver->solve(x.data()));
      EXPECT_LE(residual(drift.pattern, values, x, b), 1.0001 * promised) << time;
    }
  }
  EXPECT_EQ(solver->statistics().solutions, 2 * rounds);
  EXPECT_LE(solver->statistics().factorizations, rounds / 3);
  EXPECT_GT(solver->statistics().iterations, rounds);
}

/// A band of unknowns in contact, constant otherwise.
TEST(OwnSolver, CondensesABody) {
  std::mt19937 random(55);
  const Pattern pattern = cube(5);
  const Condensation condensation{random_definite(random, pattern), {0, 1, 2, 30, 31, 32}};
  const auto solver = make_condensed(pattern, condensation, make_schur(std::make_unique<OwnSolver>()));
  for (double spring : {0.0, 1e3, 1.0}) {
    Values values = condensation.constant;
    for (int i : {1, 31}) values[pattern.find(i, i)] += spring;
    EXPECT_LT(backward_error(*solver, pattern, values), 1e-14) << spring;
  }
}

} // namespace own_solver_test
} // namespace signorini::solve
