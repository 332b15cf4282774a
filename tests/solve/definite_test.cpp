// The signs of the eigenvalues of symmetric matrices.
#include "solve/definite.hpp"

#include "solve/matrices.hpp"

#include <gtest/gtest.h>

namespace signorini::solve {
namespace definite_test {

using namespace test;

/// Second differences less a shift: λ_k = 2 − 2 cos(π k/(n + 1)) − σ.
TEST(Definite, CountsNegativeEigenvaluesOfAChain) {
  constexpr int n = 60;
  std::vector<std::vector<int>> groups;
  for (int i = 0; i + 1 < n; ++i) groups.push_back({i, i + 1});
  const Pattern pattern = couple(n, groups);
  for (const int below : {0, 1, 7, n}) {
    const double shift = 2 - 2 * std::cos(M_PI * (below + 0.5) / (n + 1));
    Values values(static_cast<std::size_t>(pattern.entries()), -1.0);
    for (int i = 0; i < n; ++i) values[pattern.find(i, i)] = 2 - shift;
    EXPECT_EQ(negative_eigenvalues(pattern, values), below);
    EXPECT_EQ(is_positive_definite(pattern, values), below == 0);
  }
}

TEST(Definite, AVanishingPivotLeavesTheCountOpen) {
  const Pattern pattern = couple(2, {{0, 1}});
  EXPECT_EQ(negative_eigenvalues(pattern, {0, 1, 1, 0}), std::nullopt);
  EXPECT_EQ(negative_eigenvalues(pattern, {1, 2, 2, 1}), 1);
}

} // namespace definite_test
} // namespace signorini::solve
