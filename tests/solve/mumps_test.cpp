// MUMPS in one process: inertia, choice of the factorization, approximate factors, files. Tests that all direct solvers
// share are in linear_test.cpp and symmetric_test.cpp; runs with several ranks in tests/lua/run/mumps_test.lua.
#include "solve/mumps.hpp"

#include "base/dense.hpp"
#include "nurbs/random_patch.hpp"
#include "scratch.hpp"
#include "solve/matrices.hpp"
#include "solve/reused.hpp"

#include <Eigen/Eigenvalues>
#include <cstdlib>
#include <gtest/gtest.h>

namespace signorini::solve {
namespace mumps_test {

using namespace test;
using Eigen::VectorXd;

class Mumps : public testing::Test {
protected:
  void SetUp() override {
    if (!has_mumps()) GTEST_SKIP() << "built without MUMPS";
  }
};

/// A with zeros in the last rows' diagonal block, as with Lagrange multipliers.
Values with_multipliers(const Pattern& pattern, Values values, int count) {
  for_entries(pattern, [&](int i, int j, int k) {
    if (std::min(i, j) >= pattern.size - count) values[k] = 0;
  });
  return values;
}

Values random_symmetric(std::mt19937& random, const Pattern& pattern) {
  Values values = random_values(random, pattern);
  for_entries(pattern, [&](int i, int j, int k) {
    if (i < j) values[k] = values[pattern.find(j, i)];
  });
  return values;
}

/// Sylvester's law of inertia: L D Lᵀ has as many negative pivots as the matrix has negative eigenvalues.
TEST_F(Mumps, CountsNegativeEigenvaluesOfSymmetricMatrices) {
  std::mt19937 random(71);
  for (const Pattern& pattern : {chain(1), chain(60), cube(4)}) {
    const auto solver = make_mumps({});
    solver->analyze(pattern);
    for (const Values& values :
         {random_definite(random, pattern), random_definite(random, pattern, -1), random_symmetric(random, pattern),
          random_symmetric(random, pattern), with_multipliers(pattern, random_definite(random, pattern), 1)}) {
      if (!solver->factor(values.data())) continue; // of size 1, the multiplier alone
      const VectorXd eigenvalues = dense::symmetric_eigenvalues(dense(pattern, values));
      EXPECT_EQ(solver->statistics().negative, (eigenvalues.array() < 0).count()) << pattern.size;
    }
  }
}

/// L D Lᵀ has half of the entries of L U, and the inertia is that of symmetric matrices.
TEST_F(Mumps, FactorsByLUFromTheFirstUnsymmetricMatrixToTheNextPattern) {
  std::mt19937 random(72);
  const Pattern pattern = cube(6);
  const Values symmetric = random_definite(random, pattern);
  Values skewed = symmetric;
  skewed[pattern.find(3, 5)] *= 1.01;
  const auto solver = make_mumps({});
  solver->analyze(pattern);
  EXPECT_LT(backward_error(*solver, pattern, symmetric), 1e-14);
  const SolverStatistics halves = solver->statistics();
  EXPECT_EQ(halves.negative, 0);
  for (const Values& values : {skewed, symmetric}) {
    EXPECT_LT(backward_error(*solver, pattern, values), 1e-14);
    EXPECT_EQ(solver->statistics().negative, -1);
    EXPECT_GT(solver->statistics().memory, 1.8 * halves.memory);
    EXPECT_GT(solver->statistics().operations, 1.8 * halves.operations);
  }
  solver->analyze(pattern);
  EXPECT_LT(backward_error(*solver, pattern, symmetric), 1e-14);
  EXPECT_EQ(solver->statistics().negative, 0);
  EXPECT_EQ(solver->statistics().factorizations, 4);
  EXPECT_EQ(solver->statistics().solutions, 8);
}

TEST_F(Mumps, CopiesWhatItNeeds) {
  std::mt19937 random(73);
  const auto solver = make_mumps({});
  for (int size : {50, 20, 80}) {
    const Pattern pattern = chain(size);
    solver->analyze(Pattern(pattern));
    const Values values = random_values(random, pattern);
    Values passing = values;
    ASSERT_TRUE(solver->factor(passing.data()));
    std::fill(passing.begin(), passing.end(), std::nan(""));
    const VectorXd b = VectorXd::LinSpaced(size, -1, 2);
    VectorXd x = b;
    ASSERT_TRUE(solver->solve(x.data()));
    EXPECT_LT((product(pattern, values, x) - b).norm(), 1e-10 * x.norm());
  }
}

/// The scalar Laplacian of seven points on a cube: of low rank between distant nodes, unlike random matrices.
std::pair<Pattern, Values> laplacian(int nodes) {
  std::vector<std::vector<int>> pairs;
  const auto each = [&](auto&& visit) {
    for (int k = 0; k < nodes; ++k)
      for (int j = 0; j < nodes; ++j)
        for (int i = 0; i < nodes; ++i) visit(i, j, k, i + nodes * (j + nodes * k));
  };
  each([&](int i, int j, int k, int node) {
    if (i + 1 < nodes) pairs.push_back({node, node + 1});
    if (j + 1 < nodes) pairs.push_back({node, node + nodes});
    if (k + 1 < nodes) pairs.push_back({node, node + nodes * nodes});
  });
  Pattern pattern = couple(nodes * nodes * nodes, pairs);
  Values values(pattern.entries());
  for_entries(pattern, [&](int i, int j, int k) { values[k] = i == j ? 6.001 : -1; });
  return {std::move(pattern), std::move(values)};
}

double relative_error(DirectSolver& solver, const Pattern& pattern, const Values& values) {
  const VectorXd b = VectorXd::LinSpaced(pattern.size, -1, 2);
  VectorXd x = b;
  EXPECT_TRUE(solver.factor(values.data()) && solver.solve(x.data()));
  return (product(pattern, values, x) - b).norm() / b.norm();
}

TEST_F(Mumps, ApproximateFactorsSaveMemoryAndPreconditionGmres) {
  const auto [pattern, values] = laplacian(26);
  const auto exact = make_mumps({});
  exact->analyze(pattern);
  EXPECT_LT(relative_error(*exact, pattern, values), 1e-12);

  const auto compressed = make_mumps({.low_rank = 1e-3});
  compressed->analyze(pattern);
  const double coarse = relative_error(*compressed, pattern, values);
  EXPECT_GT(coarse, 1e-9);
  EXPECT_LT(coarse, 1e-1);
  EXPECT_LT(compressed->statistics().memory, 0.95 * exact->statistics().memory);
  EXPECT_LT(compressed->statistics().operations, exact->statistics().operations);

  const auto single = make_mumps({.single = true});
  single->analyze(pattern);
  const double rounded = relative_error(*single, pattern, values);
  EXPECT_GT(rounded, 1e-9);
  EXPECT_LT(rounded, 1e-4);
  EXPECT_EQ(single->statistics().memory, 0.5 * exact->statistics().memory);

  for (const MumpsOptions& options : {MumpsOptions{.settings = {.low_rank = 1e-3}},
                                      MumpsOptions{.settings = {.single = true}}, MumpsOptions{.reuse = true}}) {
    const auto solver = make_solver(LinearKind::mumps, pattern, {.mumps = options});
    EXPECT_EQ(solver->kind(), LinearKind::mumps);
    const VectorXd b = VectorXd::LinSpaced(pattern.size, -1, 2);
    ASSERT_TRUE(solver->factor(values.data()));
    for (double promised : {loosest_tolerance, tightest_tolerance}) {
      VectorXd x = b;
      ASSERT_TRUE(solver->solve(x.data()));
      EXPECT_LE((product(pattern, values, x) - b).norm(), 1.0001 * promised * b.norm());
    }
    EXPECT_EQ(solver->statistics().factorizations, 1);
  }
}

TEST_F(Mumps, StoresFactorsInAFolderAndRemovesThem) {
  std::mt19937 random(74);
  const signorini::test::ScratchFolder folder;
  const Pattern pattern = cube(8);
  const Values values = random_definite(random, pattern);
  {
    const auto solver = make_mumps({.folder = folder.file("")});
    solver->analyze(pattern);
    EXPECT_LT(backward_error(*solver, pattern, values), 1e-14);
    EXPECT_GT(folder.count(), 0);
  }
  EXPECT_EQ(folder.count(), 0);
  EXPECT_ERROR(make_mumps({.folder = "/nowhere/at/all"}), "solve.mumps.folder: folder = /nowhere/at/all");
  const std::string file = folder.file("file");
  std::fclose(std::fopen(file.c_str(), "w"));
  EXPECT_ERROR(make_mumps({.folder = file}), "solve.mumps.folder: folder = " + file);
  const std::string long_name(300, 'x');
  EXPECT_ERROR(make_mumps({.folder = long_name}), "solve.mumps.folder_length: folder = " + long_name + ", most = 255");
}

TEST_F(Mumps, AProcessWithoutMpirunRunsTheProgram) {
  EXPECT_EQ(started_ranks(), 0);
  EXPECT_TRUE(leads_ranks("1.0"));
}

/// CMake runs it by mpirun on two ranks, which say that they have different versions.
TEST_F(Mumps, RefusesRanksOfAnotherVersion) {
  if (started_ranks() != 2) GTEST_SKIP() << "needs two ranks";
  const std::string rank = std::getenv("OMPI_COMM_WORLD_RANK");
  if (rank == "0")
    EXPECT_ERROR(leads_ranks("version of rank 0"), "solve.mumps.versions");
  else
    EXPECT_FALSE(leads_ranks("version of rank 1"));
}

} // namespace mumps_test
} // namespace signorini::solve
