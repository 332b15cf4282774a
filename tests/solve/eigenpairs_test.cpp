#include "solve/eigenpairs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::solve {
namespace eigenpairs_test {

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

TEST(Eigenpairs, OfAnUnsymmetricMatrixMayBeComplex) {
  // Eigenvalues 2 ± 3i and 7 in another basis
  MatrixX matrix(3, 3), basis(3, 3);
  matrix << 2, 3, 0, -3, 2, 0, 0, 0, 7;
  basis << 1, 2, 0, 0, 1, 1, 1, 0, 3;
  matrix = (basis * matrix * basis.inverse()).eval();
  const auto [values, vectors] = eigenpairs(matrix);
  ASSERT_EQ(values.size(), 3);
  for (int k = 0; k < 3; ++k) {
    const bool is_real = std::abs(values(k).imag()) < 1e-12;
    EXPECT_NEAR(std::abs(values(k) - (is_real ? 7.0 : std::complex(2.0, values(k).imag() > 0 ? 3.0 : -3.0))), 0, 1e-12);
    if (values(k).imag() <= 0 && !is_real) continue;
    // A (a + bi) = κ (a + bi)
    Eigen::VectorXcd vector = vectors.col(k).cast<std::complex<double>>();
    if (!is_real) vector += std::complex(0.0, 1.0) * vectors.col(k + 1).cast<std::complex<double>>();
    EXPECT_NEAR((matrix * vector - values(k) * vector).norm(), 0, 1e-12);
  }
}

} // namespace eigenpairs_test
} // namespace signorini::solve
