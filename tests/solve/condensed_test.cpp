// A constant matrix with a changing contact block, by several solvers, compared with UMFPACK and dense LU of the whole.
#include "solve/condensed.hpp"

#include "base/dense.hpp"
#include "nurbs/random_patch.hpp"
#include "os/parallel.hpp"
#include "solve/matrices.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace signorini::solve {
namespace condensed_test {

using namespace test;

std::vector<int> random_subset(std::mt19937& random, int size, int count) {
  std::vector<int> all(size);
  std::iota(all.begin(), all.end(), 0);
  std::shuffle(all.begin(), all.end(), random);
  all.resize(count);
  std::sort(all.begin(), all.end());
  return all;
}

/// K₀ with a random unsymmetric C in a fraction of the entries between contact unknowns.
Values with_contact(std::mt19937& random, const Pattern& pattern, const Condensation& condensation, double part,
                    double size) {
  std::vector<char> touched(pattern.size, 0);
  for (int unknown : condensation.contact) touched[unknown] = 1;
  Values values = condensation.constant;
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<char> active(pattern.size);
  for (char& flag : active) flag = uniform(random) < part;
  for_entries(pattern, [&](int i, int j, int k) {
    if (touched[i] && touched[j] && active[i] && active[j]) values[k] += size * (uniform(random) + (i == j ? 4 : 0));
  });
  return values;
}

/// Operations per entry above which the interior is dissected: both orderings.
constexpr double orderings[] = {500, 0};

TEST(SchurSolvers, ReturnTheComplementAndSolve) {
  std::mt19937 random(17);
  for (const double dissect_above : orderings)
    for (const Pattern& pattern : {chain(1), chain(13), chain(120), cube(5)})
      for (int part : {0, 1, 3}) {
        const int size = pattern.size, count = part * size / 3;
        const Values values = random_definite(random, pattern);
        const auto solver = make_schur_cholesky(dissect_above);
        solver->analyze(pattern, random_subset(random, size, count));
        ASSERT_TRUE(solver->factor(values.data()));
        const std::vector<int>& border = solver->border();
        ASSERT_EQ(static_cast<int>(border.size()), count);
        std::vector<int> interior;
        for (int i = 0; i < size; ++i)
          if (std::find(border.begin(), border.end(), i) == border.end()) interior.push_back(i);
        const Eigen::MatrixXd a = dense(pattern, values);
        Eigen::MatrixXd complement = a(border, border);
        if (!interior.empty())
          complement -= a(border, interior) * dense::solve(a(interior, interior), a(interior, border));
        EXPECT_LT((solver->complement() - complement).norm(), 1e-12 * a.norm());
        const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(size, -1, 2);
        Eigen::VectorXd x = b;
        ASSERT_TRUE(solver->solve(x.data(), [&](double* right) {
          Eigen::Map<Eigen::VectorXd> rest(right, count);
          if (count > 0) rest = dense::solve(solver->complement(), rest);
          return true;
        }));
        EXPECT_LT((a * x - b).norm(), 1e-12 * b.norm()) << size << " " << count;
      }
}

/// Large enough for subtrees of the elimination tree as tasks; with a border whose unknowns are scattered.
TEST(SchurSolvers, SolutionsAreBitwiseIdenticalForAnyNumberOfThreads) {
  std::mt19937 random(18);
  const Pattern pattern = cube(14);
  const Values values = random_definite(random, pattern);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(pattern.size, -1, 2);
  for (const Precision precision : {Precision::full, Precision::single}) {
    const auto solver = make_schur_cholesky(0, precision);
    solver->analyze(pattern, random_subset(random, pattern.size, 40));
    ASSERT_TRUE(solver->factor(values.data()));
    const auto solution = [&] {
      Eigen::VectorXd x = b;
      EXPECT_TRUE(solver->solve(x.data(), [&](double* right) {
        Eigen::Map<Eigen::VectorXd> rest(right, 40);
        rest = dense::solve(solver->complement(), rest);
        return true;
      }));
      return x;
    };
    const Eigen::VectorXd one = solution();
    set_worker_threads(2);
    const Eigen::VectorXd two = solution();
    set_worker_threads(1);
    EXPECT_EQ(one, two);
    EXPECT_LT((product(pattern, values, one) - b).norm(), (precision == Precision::full ? 1e-12 : 1e-4) * b.norm());
  }
}

/// Soft springs in a chain whose ends are tied by a multiplier of any scale in the border: its row has no positive
/// diagonal, and the shift that makes the whole positive definite depends on the compliance.
TEST(SchurSolvers, BorderMayContainMultipliers) {
  for (const double scale : {1e-3, 1.0, 30.0, 1e3})
    for (const double softness : {1.0, 1e-4}) {
      const int size = 40, multiplier = size;
      std::vector<std::vector<int>> groups{{0, multiplier}, {size - 1, multiplier}};
      for (int i = 0; i + 1 < size; ++i) groups.push_back({i, i + 1});
      const Pattern pattern = couple(size + 1, groups);
      Values values(pattern.rows.size(), 0.0);
      for_entries(pattern, [&](int i, int j, int k) {
        const bool row = i == multiplier, column = j == multiplier;
        if (row || column)
          values[k] = row && column ? -1e-8 * scale : (std::min(i, j) == 0 ? scale : -scale);
        else
          values[k] = i == j ? 2 + softness : -1;
      });
      const auto solver = make_schur_cholesky(500);
      solver->analyze(pattern, {multiplier});
      ASSERT_TRUE(solver->factor(values.data())) << scale << " " << softness;
      const Eigen::MatrixXd a = dense(pattern, values);
      const Eigen::MatrixXd interior = a.topLeftCorner(size, size);
      const Eigen::VectorXd column = a.col(size).head(size);
      const double complement = a(size, size) - column.dot(dense::solve(interior, column).col(0));
      EXPECT_NEAR(solver->complement()(0, 0), complement, 1e-8 * std::abs(complement)) << scale << " " << softness;
    }
  // An interior that is not positive definite fails, whatever the shifts are.
  const Pattern pattern = chain(3);
  Values values(pattern.rows.size(), 0.0);
  for_entries(pattern, [&](int i, int j, int k) { values[k] = i == j ? -1 : 0.1; });
  const auto solver = make_schur_cholesky(500);
  solver->analyze(pattern, {2});
  EXPECT_FALSE(solver->factor(values.data()));
}

TEST(Condensed, SolvesChangingContactBlocks) {
  std::mt19937 random(11);
  for (const auto& [size, contacts] : {std::pair{1, 1}, {2, 1}, {13, 0}, {13, 5}, {13, 13}, {120, 40}, {400, 399}}) {
    const Pattern pattern = chain(size);
    const Condensation condensation{random_definite(random, pattern), random_subset(random, size, contacts)};
    std::vector<std::unique_ptr<LinearSolver>> solvers;
    solvers.push_back(make_solver(LinearKind::condensed, pattern, {&condensation}));
    for (const double dissect_above : orderings)
      solvers.push_back(make_condensed(pattern, condensation, make_schur_cholesky(dissect_above)));
    const auto oracle = make_solver(LinearKind::umfpack, pattern);
    EXPECT_EQ(solvers.front()->kind(), LinearKind::condensed);
    // From no contact to full contact, and a contact that is much stiffer than the bulk
    for (double part : {0.0, 0.1, 0.2, 0.1, 0.5, 1.0, 0.0})
      for (double stiffness : {1.0, 1e4}) {
        SCOPED_TRACE(text(size, " unknowns, ", contacts, " in contact, part ", part, ", stiffness ", stiffness));
        const Values values = with_contact(random, pattern, condensation, part, stiffness);
        const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(size, 1, 2);
        const Eigen::VectorXd z = dense::solve(dense(pattern, values), b);
        Eigen::VectorXd y = b;
        ASSERT_TRUE(oracle->factor(values.data()) && oracle->solve(y.data()));
        for (const auto& solver : solvers) {
          EXPECT_LT(backward_error(*solver, pattern, values), 1e-14);
          Eigen::VectorXd x = b;
          ASSERT_TRUE(solver->solve(x.data()));
          EXPECT_LT((x - y).norm(), 1e-12 * y.norm());
          EXPECT_LT((x - z).norm(), 1e-12 * z.norm());
        }
      }
  }
}

/// Compared with the least eigenvalue of the symmetric part, by another algorithm.
TEST(Condensed, ProvesThatTheSymmetricPartIsDefinite) {
  std::mt19937 random(13);
  const Pattern pattern = chain(60);
  const Condensation condensation{random_definite(random, pattern), random_subset(random, 60, 12)};
  const auto solver = make_solver(LinearKind::condensed, pattern, {&condensation});
  int definite = 0, others = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const Values values =
        with_contact(random, pattern, condensation, 0.5, (trial % 2 ? -1 : 1) * std::pow(10.0, trial % 8 - 3));
    const MatrixX k = dense(pattern, values);
    const double least = dense::symmetric_eigenvalues(0.5 * (k + k.transpose()))(0);
    ASSERT_GT(std::abs(least), 1e-10);
    EXPECT_EQ(solver->proves_definite(values.data()), least > 0);
    ++(least > 0 ? definite : others);
  }
  EXPECT_GT(definite, 5);
  EXPECT_GT(others, 5);
}

/// Springs that only contact supports: K₀ is singular, K₀ + C is not.
TEST(Condensed, ContactMayBeTheOnlySupport) {
  std::mt19937 random(12);
  const auto [pattern, constant] = free_springs(random, 60);
  const Condensation condensation{constant, {20, 21, 22, 23, 59}};
  const auto solver = make_solver(LinearKind::condensed, pattern, {&condensation});
  EXPECT_FALSE(solver->factor(constant.data()));
  Values supported = constant;
  for (int unknown : {21, 59, 20}) {
    supported[pattern.find(unknown, unknown)] += 0.7;
    EXPECT_LT(backward_error(*solver, pattern, supported), 1e-14);
    EXPECT_FALSE(solver->factor(constant.data())); // contact lost, and established again
    EXPECT_LT(backward_error(*solver, pattern, supported), 1e-14);
  }
  // With very weak support the position of the springs keeps the digits that the matrix has.
  Values weak = constant;
  weak[pattern.find(22, 22)] += 1e-6;
  EXPECT_LT(backward_error(*solver, pattern, weak), 1e-14);
}

TEST(Condensed, UnconstrainedBodyWithoutContactIsSingular) {
  std::mt19937 random(13);
  const auto [pattern, constant] = free_springs(random, 30);
  Condensation condensation{constant, {}};
  EXPECT_FALSE(make_solver(LinearKind::condensed, pattern, {&condensation})->factor(constant.data()));
  // Two chains; only the second has contact unknowns
  Condensation halves{constant, {25, 26}};
  for (const auto& [i, j] : {std::pair{14, 15}, {15, 14}}) {
    const double coupling = halves.constant[pattern.find(i, j)];
    halves.constant[pattern.find(i, j)] = 0;
    halves.constant[pattern.find(i, i)] += coupling;
  }
  Values values = halves.constant;
  values[pattern.find(25, 25)] += 1;
  EXPECT_FALSE(make_solver(LinearKind::condensed, pattern, {&halves})->factor(values.data()));
}

TEST(Condensed, SingularMatricesByTheContactBlockAreReportedAndLeaveNoTrace) {
  std::mt19937 random(14);
  const Pattern pattern = chain(40);
  const Condensation condensation{random_definite(random, pattern), {3, 5, 17, 30}};
  const auto solver = make_solver(LinearKind::condensed, pattern, {&condensation});
  // The Schur complement onto unknown 17 is 1 / (K⁻¹)₁₇,₁₇; subtracting it makes the matrix singular.
  Values values = condensation.constant;
  values[pattern.find(17, 17)] -= 1 / dense(pattern, values).inverse()(17, 17);
  EXPECT_FALSE(solver->factor(values.data()));
  values[pattern.find(17, 17)] = std::nan("");
  EXPECT_FALSE(solver->factor(values.data()));
  EXPECT_LT(backward_error(*solver, pattern, condensation.constant), 1e-14);
}

TEST(Condensed, InvalidInputIsAnError) {
  const Pattern pattern = chain(13);
  std::mt19937 random(15);
  const Values constant = random_definite(random, pattern);
  const auto make = [&](const Condensation& condensation) {
    make_solver(LinearKind::condensed, pattern, {&condensation});
  };
  EXPECT_ERROR(make_solver(LinearKind::condensed, pattern), "solve.linear.condensed");
  EXPECT_ERROR(make({{1.0, 2.0}, {}}), "solve.condensed.size: count = 2, expected = 61");
  for (const std::vector<int>& contact : {std::vector{-1}, {13}, {3, 3}, {4, 2}})
    EXPECT_ERROR(make({constant, contact}), "solve.condensed.contact: most = 12");
  Values unsymmetric = constant;
  unsymmetric[pattern.find(1, 2)] += 0.1;
  EXPECT_ERROR(make({unsymmetric, {}}), "solve.condensed.symmetric");
}

/// Finite differences of a membrane on 100 × 40 points whose lowest two rows are in contact.
TEST(Condensed, SolvesAGridWithAContactFace) {
  constexpr int wide = 100, high = 40;
  std::vector<std::vector<int>> groups;
  for (int y = 0; y + 1 < high; ++y)
    for (int x = 0; x + 1 < wide; ++x) {
      const int i = y * wide + x;
      groups.push_back({i, i + 1, i + wide, i + wide + 1});
    }
  const Pattern pattern = couple(wide * high, groups);
  std::mt19937 random(16);
  Condensation condensation{Values(pattern.entries(), 0.0), {}};
  for_entries(pattern, [&](int i, int j, int k) { condensation.constant[k] = i == j ? 8 : -1; });
  for (int i = 0; i < 2 * wide; ++i) condensation.contact.push_back(i);

  const auto solver = make_solver(LinearKind::condensed, pattern, {&condensation});
  for (int round = 0; round < 9; ++round)
    EXPECT_LT(backward_error(*solver, pattern, with_contact(random, pattern, condensation, 0.3, 100)), 1e-14);
}

} // namespace condensed_test
} // namespace signorini::solve
