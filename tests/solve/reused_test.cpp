// Reused factorizations on sequences of tangents: accuracy as specified, renewal if worthwhile, reproducibility.
#include "solve/reused.hpp"
#include "solve/values.hpp"

#include "os/parallel.hpp"
#include "solve/matrices.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace signorini::solve {
namespace reused_test {

using namespace test;
using Eigen::VectorXd;

TEST(Reused, SolvesDriftingTangentsWithFewFactorizations) {
  std::mt19937 random(41);
  for (double skew : {0.0, 1.0, 10.0}) {
    const Drift drift(random, cube(7), skew);
    const auto solver = make_solver(LinearKind::reuse, drift.pattern);
    EXPECT_EQ(solver->kind(), LinearKind::reuse);
    const int rounds = 40;
    for (int time = 0; time < rounds; ++time) {
      const Values values = drift.at_time(time);
      ASSERT_TRUE(solver->factor(values.data()));
      for (double promised : {loosest_tolerance, tightest_tolerance}) {
        const VectorXd b = VectorXd::LinSpaced(drift.pattern.size, time % 3 - 1, 2);
        VectorXd x = b;
        ASSERT_TRUE(solver->solve(x.data()));
        EXPECT_LE(residual(drift.pattern, values, x, b), 1.0001 * promised) << skew << " " << time;
      }
    }
    const SolverStatistics statistics = solver->statistics();
    EXPECT_EQ(statistics.solutions, 2 * rounds);
    EXPECT_GE(statistics.factorizations, 1);
    EXPECT_LE(statistics.factorizations, rounds / 3) << skew;
    EXPECT_GT(statistics.memory, sizeof(double) * drift.pattern.entries() / 2.0);
  }
}

TEST(Reused, SolvesCorrectionsOfMultipliersMoreAccurately) {
  std::mt19937 random(54);
  const Drift drift(random, cube(6), 10);
  for (bool multipliers : {false, true}) {
    const auto solver = make_solver(LinearKind::reuse, drift.pattern, {.multipliers = multipliers});
    double worst = 0;
    for (int time = 0; time < 10; ++time) {
      const Values values = drift.at_time(time);
      ASSERT_TRUE(solver->factor(values.data()));
      const VectorXd b = VectorXd::LinSpaced(drift.pattern.size, -1, 2);
      VectorXd x = b;
      ASSERT_TRUE(solver->solve(x.data()));
      worst = std::max(worst, residual(drift.pattern, values, x, b));
    }
    EXPECT_EQ(worst > 1.0001 * loosest_for_multipliers, !multipliers) << worst;
  }
}

/// As in the first predictor of arc-length continuation: a zero residual, then the rate of the prescribed
/// displacements.
TEST(Reused, RightHandSideAfterZeroIsSolvedTightly) {
  std::mt19937 random(53);
  const Drift drift(random, cube(4), 10);
  const Values values = drift.at_time(1);
  const auto solver = make_solver(LinearKind::reuse, drift.pattern);
  ASSERT_TRUE(solver->factor(values.data()));
  const VectorXd b = VectorXd::LinSpaced(drift.pattern.size, -1, 2);
  VectorXd nothing = VectorXd::Zero(drift.pattern.size), x = b;
  ASSERT_TRUE(solver->solve(nothing.data()) && solver->solve(x.data()));
  EXPECT_EQ(nothing.norm(), 0);
  EXPECT_LE(residual(drift.pattern, values, x, b), 1.0001 * tightest_tolerance);
}

TEST(Reused, SolvesFullyOnRequest) {
  std::mt19937 random(57);
  const Drift drift(random, cube(6), 10);
  for (bool fully : {false, true}) {
    const auto solver = make_solver(LinearKind::reuse, drift.pattern);
    double worst = 0;
    for (int time = 0; time < 10; ++time) {
      const Values values = drift.at_time(time);
      ASSERT_TRUE(solver->factor(values.data()));
      const VectorXd b = VectorXd::LinSpaced(drift.pattern.size, -1, 2);
      VectorXd x = b;
      ASSERT_TRUE(solver->solve(x.data(), fully));
      worst = std::max(worst, residual(drift.pattern, values, x, b));
    }
    EXPECT_EQ(worst > 1.0001 * tightest_tolerance, !fully) << worst;
  }
}

TEST(Reused, FactorsAgainAfterAJumpOfTheMatrix) {
  std::mt19937 random(42);
  const Pattern pattern = cube(5);
  const auto solver = make_solver(LinearKind::reuse, pattern);
  const VectorXd b = VectorXd::LinSpaced(pattern.size, -1, 2);
  int before = 0;
  for (double diagonal : {1.0, 1e4, -1.0, 1e-4, 1.0}) {
    Values values = random_definite(random, pattern, diagonal);
    const Values noise = random_values(random, pattern);
    for (std::size_t k = 0; k < values.size(); ++k) values[k] += std::abs(diagonal) * noise[k];
    ASSERT_TRUE(solver->factor(values.data()));
    for (double promised : {loosest_tolerance, tightest_tolerance}) {
      VectorXd x = b;
      ASSERT_TRUE(solver->solve(x.data()));
      EXPECT_LE(residual(pattern, values, x, b), 1.0001 * promised) << diagonal;
    }
    EXPECT_GT(solver->statistics().factorizations, before) << diagonal;
    before = solver->statistics().factorizations;
  }
}

/// Unrelated indefinite unsymmetric matrices: pivoting is needed every time.
TEST(Reused, PivotsIfTheSymmetricPartIsIndefinite) {
  std::mt19937 random(43);
  const Pattern pattern = chain(300);
  const auto solver = make_solver(LinearKind::reuse, pattern);
  const VectorXd b = VectorXd::LinSpaced(pattern.size, -1, 2);
  for (int round = 0; round < 10; ++round) {
    const Values values = random_values(random, pattern);
    ASSERT_TRUE(solver->factor(values.data()));
    for (double promised : {loosest_tolerance, tightest_tolerance}) {
      VectorXd x = b;
      ASSERT_TRUE(solver->solve(x.data()));
      EXPECT_LE(residual(pattern, values, x, b), 1.0001 * promised) << round;
    }
  }
}

TEST(Reused, ReportsSingularMatricesAndRecovers) {
  std::mt19937 random(44);
  auto [pattern, free] = free_springs(random, 200);
  Values supported = free;
  supported[pattern.find(0, 0)] += 1;
  const VectorXd b = VectorXd::LinSpaced(pattern.size, -1, 2);
  const auto solves = [&, &pattern = pattern](LinearSolver& solver, const Values& values) {
    VectorXd x = b;
    return solver.factor(values.data()) && solver.solve(x.data()) &&
           residual(pattern, values, x, b) <= 1.0001 * loosest_tolerance;
  };
  for (bool supported_before : {false, true}) {
    const auto solver = make_solver(LinearKind::reuse, pattern);
    if (supported_before) {
      EXPECT_TRUE(solves(*solver, supported));
    }
    for (int round = 0; round < 2; ++round) {
      EXPECT_FALSE(solves(*solver, free));
      EXPECT_FALSE(solves(*solver, Values(supported.size(), 0.0)));
      EXPECT_TRUE(solves(*solver, supported));
    }
  }
}

TEST(Reused, ResultsAreBitwiseReproducibleAndIndependentOfThreads) {
  std::mt19937 random(45);
  const Drift drift(random, cube(5), 10);
  const auto run = [&] {
    const auto solver = make_solver(LinearKind::reuse, drift.pattern);
    VectorXd sum = VectorXd::Zero(drift.pattern.size);
    for (int time = 0; time < 30; ++time) {
      const Values values = drift.at_time(7 * time);
      VectorXd x = VectorXd::LinSpaced(drift.pattern.size, time % 3 - 1, 2);
      EXPECT_TRUE(solver->factor(values.data()) && solver->solve(x.data()));
      sum += x;
    }
    return sum;
  };
  const VectorXd first = run();
  EXPECT_EQ(run(), first);
  set_worker_threads(2);
  EXPECT_EQ(run(), first);
  set_worker_threads(1);
}

TEST(Reused, SurvivesAChangeOfPattern) {
  std::mt19937 random(46);
  Drift drift(random, cube(6), 1);
  const auto solver = make_solver(LinearKind::reuse, drift.pattern);
  const VectorXd b = VectorXd::LinSpaced(drift.pattern.size, -1, 2);
  for (int round = 0; round < 8; ++round) {
    const Values values = drift.at_time(round);
    ASSERT_TRUE(solver->factor(values.data()));
    VectorXd x = b;
    ASSERT_TRUE(solver->solve(x.data()));
    EXPECT_LE(residual(drift.pattern, values, x, b), 1.0001 * loosest_tolerance);
    // Nodes of two opposite faces come into contact.
    std::vector<int> moved;
    const int node = 3 * round, other = drift.pattern.size - 3 - node;
    const Pattern next = extend(drift.pattern, {{node, node + 1, other, other + 1}}, moved);
    Values grown(next.entries(), 0.0), grown_change(next.entries(), 0.0);
    for (std::size_t k = 0; k < moved.size(); ++k) {
      grown[moved[k]] = drift.base[k];
      grown_change[moved[k]] = drift.change[k];
    }
    grown[next.find(node, other)] = grown[next.find(other, node)] = -1;
    drift.base = grown;
    drift.change = grown_change;
    drift.pattern = next;
    ASSERT_TRUE(solver->adopt(next));
  }
  EXPECT_LE(solver->statistics().factorizations, 4);
}

/// Springs between watched unknowns appear and disappear: only one factorization, and few iterations.
TEST(Reused, WatchedUnknownsMayChangeArbitrarily) {
  std::mt19937 random(51);
  const Pattern pattern = cube(7);
  const Values base = random_definite(random, pattern);
  std::vector<int> watched;
  for (int i = 0; i < 3 * 7 * 7; ++i) watched.push_back(i);
  const auto run = [&](bool watch) {
    const auto solver = make_solver(LinearKind::reuse, pattern);
    if (watch) solver->watch(watched);
    std::mt19937 springs(52);
    for (int round = 0; round < 20; ++round) {
      Values values = base;
      for (int i : watched)
        if (springs() % 2) values[pattern.find(i, i)] += 1000;
      EXPECT_TRUE(solver->factor(values.data()));
      const VectorXd b = VectorXd::LinSpaced(pattern.size, -1, 2);
      VectorXd x = b;
      EXPECT_TRUE(solver->solve(x.data()));
      EXPECT_LE(residual(pattern, values, x, b), 1.0001 * loosest_tolerance);
    }
    return solver->statistics();
  };
  const SolverStatistics with = run(true), without = run(false);
  EXPECT_EQ(with.factorizations, 1);
  EXPECT_EQ(with.iterations, with.solutions);
  EXPECT_GT(without.iterations + without.factorizations, 2 * with.iterations);
}

TEST(Forcing, IsATenthOfTheResidualLeftByQuadraticConvergence) {
  Forcing forcing;
  EXPECT_DOUBLE_EQ(forcing.next(1), loosest_tolerance);    // no history
  EXPECT_DOUBLE_EQ(forcing.next(2e-2), 0.1 * 2e-2 * 2e-2); // r₂ ≈ r₁ (r₁/r₀)²
  EXPECT_DOUBLE_EQ(forcing.next(1e-5), 0.1 * 5e-4 * 5e-4);
  EXPECT_DOUBLE_EQ(forcing.next(1e-14), tightest_tolerance);
  EXPECT_DOUBLE_EQ(forcing.next(3), 0.1 * 2e-2 * 2e-2); // a new step, as good as the last one
  EXPECT_DOUBLE_EQ(forcing.next(2.9), loosest_tolerance);
  EXPECT_DOUBLE_EQ(forcing.next(3), loosest_tolerance);
}

/// Newton's method for (K + 0.3 N(x)) x = b with stiffening springs, x ↦ x³, and an unsymmetric coupling.
TEST(Reused, NewtonConvergesAsWithExactSolutions) {
  std::mt19937 random(48);
  const Drift drift(random, cube(5), 10);
  const Pattern& pattern = drift.pattern;
  const Values linear = drift.at_time(15);
  const auto run = [&](LinearKind kind, std::vector<int>& iterations) {
    const auto solver = make_solver(kind, pattern);
    VectorXd x = VectorXd::Zero(pattern.size);
    for (int step = 1; step <= 6; ++step) {
      const VectorXd b = step * VectorXd::LinSpaced(pattern.size, -1, 3);
      iterations.push_back(0);
      for (;; ++iterations.back()) {
        const VectorXd rest = b - product(pattern, linear, x) - VectorXd(x.array().cube());
        if (rest.norm() <= 1e-10 * b.norm()) break;
        Values tangent = linear;
        for (int i = 0; i < pattern.size; ++i) tangent[pattern.find(i, i)] += 3 * x(i) * x(i);
        VectorXd correction = rest;
        EXPECT_TRUE(solver->factor(tangent.data()) && solver->solve(correction.data()));
        x += correction;
      }
    }
    return x;
  };
  std::vector<int> exact_iterations, iterations;
  const VectorXd exact = run(LinearKind::umfpack, exact_iterations), x = run(LinearKind::reuse, iterations);
  EXPECT_EQ(iterations, exact_iterations);
  EXPECT_LT((x - exact).norm(), 1e-9 * exact.norm());
}

} // namespace reused_test
} // namespace signorini::solve
