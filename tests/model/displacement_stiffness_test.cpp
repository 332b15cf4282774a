// The stiffness of displacements that conditions constrain, against the inverse of the dense matrix.
#include "model/stability/displacement_stiffness.hpp"

#include "base/eigen.hpp"
#include "model/constants.hpp"

#include <Eigen/LU>

#include <gtest/gtest.h>

namespace signorini::model {
namespace displacement_stiffness_test {

/// All entries that are not zero, or whose transposed one is not.
Stiffness sparse(const MatrixX& k) {
  const int size = static_cast<int>(k.rows());
  Stiffness result{{size, {0}, {}}, {}};
  for (int j = 0; j < size; ++j) {
    for (int i = 0; i < size; ++i)
      if (i == j || k(i, j) != 0 || k(j, i) != 0) {
        result.pattern.rows.push_back(i);
        result.values.push_back(k(i, j));
      }
    result.pattern.starts.push_back(result.pattern.entries());
  }
  return result;
}

MatrixX dense(const Stiffness& k) {
  MatrixX result = MatrixX::Zero(k.pattern.size, k.pattern.size);
  for (int j = 0; j < k.pattern.size; ++j)
    for (int i = 0; i < k.pattern.size; ++i)
      if (const int place = k.pattern.find(i, j); place >= 0) result(i, j) = k.values[place];
  return result;
}

/// Springs between four displacements, two of which conditions 4 and 5 prescribe. K_χχ couples these in one direction,
/// forward or backward, as points that slip do.
TEST(DisplacementStiffness, CouplingsOfMultipliersMayBeOneSided) {
  for (const bool forward : {false, true}) {
    MatrixX k = MatrixX::Zero(6, 6);
    k.topLeftCorner(4, 4) << 3, -1, 0, 0, -1, 3, -1, 0, 0, -1, 3, -1, 0, 0, -1, 3;
    for (const auto& [i, j] : {std::pair{4, 1}, std::pair{5, 2}}) k(i, j) = k(j, i) = 1;
    k(4, 4) = k(5, 5) = -0.5;
    (forward ? k(5, 4) : k(4, 5)) = 0.25;
    const Stiffness given = sparse(k);
    const MatrixX found = dense(displacement_stiffness(given.pattern, given.values, 4));
    MatrixX inner = k.bottomRightCorner(2, 2);
    inner.diagonal().array() -= 1 / (constraint_stiffness * 3);
    const MatrixX expected =
        k.topLeftCorner(4, 4) - k.topRightCorner(4, 2) * inner.inverse() * k.bottomLeftCorner(2, 4);
    EXPECT_LT((found - expected).norm(), 1e-12) << "forward: " << forward;
  }
}

/// Two multipliers of two components each, coupled by overlapping functions: lumped, each is eliminated on its own.
TEST(DisplacementStiffness, LumpsOverlappingMultipliers) {
  MatrixX k = MatrixX::Zero(8, 8);
  k.topLeftCorner(4, 4) << 3, -1, 0, 0, -1, 3, -1, 0, 0, -1, 3, -1, 0, 0, -1, 3;
  for (int i = 0; i < 4; ++i) k(4 + i, i) = k(i, 4 + i) = 1 + i;
  const MatrixX own{{-2, 0.5}, {0.25, -3}};
  for (const auto& [i, j, share] : {std::tuple{4, 4, 2.0}, {4, 6, 1.0}, {6, 4, 1.0}, {6, 6, 2.0}})
    k.block(i, j, 2, 2) = share * own;
  const Stiffness given = sparse(k);
  MatrixX expected = k.topLeftCorner(4, 4);
  for (const int first : {4, 6}) {
    MatrixX inner = 3 * own;
    for (int c = 0; c < 2; ++c) inner(c, c) -= std::pow(k(first + c, first - 4 + c), 2) / (constraint_stiffness * 3);
    expected -= k.block(0, first, 4, 2) * inner.inverse() * k.block(first, 0, 2, 4);
  }
  const MatrixX found = dense(displacement_stiffness(given.pattern, given.values, 4, {2, 2, 2, 2}));
  EXPECT_LT((found - expected).norm(), 1e-12);
}

} // namespace displacement_stiffness_test
} // namespace signorini::model
