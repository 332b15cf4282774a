#include "solve/least_eigenpair.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::solve {
namespace least_eigenpair_test {

TEST(LeastEigenpair, IsThatOfASmallMatrix) {
  // Second differences of n points: λ = 2 − 2 cos(π/(n+1)), v_i ~ sin(π i/(n+1)).
  const int n = 6;
  MatrixX matrix = 2 * MatrixX::Identity(n, n);
  for (int i = 0; i + 1 < n; ++i) matrix(i, i + 1) = matrix(i + 1, i) = -1;
  const auto [value, vector] = least_eigenpair(matrix);
  EXPECT_NEAR(value, 2 - 2 * std::cos(M_PI / (n + 1)), 1e-13);
  EXPECT_NEAR(vector.norm(), 1, 1e-13);
  EXPECT_NEAR(std::abs(vector(0) / vector(2)), std::sin(M_PI / 7) / std::sin(3 * M_PI / 7), 1e-13);
}

} // namespace least_eigenpair_test
} // namespace signorini::solve
