// Memory of factors estimated from the pattern, compared with that reported by the solvers.
#include "solve/factor_estimate.hpp"
#include "solve/matrices.hpp"

#include <gtest/gtest.h>

namespace signorini::solve {
namespace factor_estimate_test {

using namespace test;

/// A sheet of nodes with two unknowns each, coupled over one element: the fill of a plane body.
Pattern sheet(int width, int height) {
  std::vector<std::vector<int>> groups;
  for (int j = 0; j + 1 < height; ++j)
    for (int i = 0; i + 1 < width; ++i) {
      const int node = i + width * j;
      std::vector<int> group;
      for (int corner : {node, node + 1, node + width, node + width + 1})
        for (int c = 0; c < 2; ++c) group.push_back(2 * corner + c);
      groups.push_back(group);
    }
  return couple(2 * width * height, groups);
}

struct Counted {
  LinearKind kind;
  double part; ///< estimated bytes as a fraction of those reported by the solver
};

/// Factors a definite matrix by solver `asked`, twice, so that `automatic` has selected its solver.
Counted compare(LinearKind asked, const Pattern& pattern) {
  std::mt19937 random(7);
  const Values values = random_definite(random, pattern);
  const FactorEstimate estimate = estimate_factor(asked, pattern);
  const auto solver = make_solver(asked, pattern);
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(solver->factor(values.data()));
  EXPECT_EQ(estimate.kind, solver->kind());
  return {estimate.kind, estimate.memory / solver->statistics().memory};
}

TEST(FactorEstimate, AgreesWithTheSolvers) {
  const Pattern plane = sheet(40, 30);
  for (LinearKind kind : {LinearKind::klu, LinearKind::umfpack, LinearKind::reuse}) {
    const Counted counted = compare(kind, plane);
    EXPECT_GT(counted.part, 0.7) << name_of(kind);
    EXPECT_LT(counted.part, 1.4) << name_of(kind);
  }
}

TEST(FactorEstimate, PredictsTheAutomaticChoice) {
  EXPECT_EQ(compare(LinearKind::automatic, sheet(12, 12)).kind, LinearKind::klu);
  EXPECT_EQ(compare(LinearKind::automatic, sheet(100, 90)).kind, LinearKind::reuse);
  const Counted solid = compare(LinearKind::automatic, cube(11));
  EXPECT_EQ(solid.kind, LinearKind::reuse);
  EXPECT_GT(solid.part, 0.8);
  EXPECT_LT(solid.part, 1.2);
}

} // namespace factor_estimate_test
} // namespace signorini::solve
