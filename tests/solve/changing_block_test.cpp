// The dense block with its changes, against LU of the whole.
#include "solve/changing_block.hpp"

#include "solve/matrices.hpp"

#include <gtest/gtest.h>

namespace signorini::solve {
namespace changing_block_test {

using namespace test;

MatrixX random_definite(int size) {
  const MatrixX half = MatrixX::Random(size, size);
  return half * half.transpose() + MatrixX::Identity(size, size);
}

double backward_error(ChangingBlock& block, const MatrixX& whole) {
  const VectorX b = VectorX::LinSpaced(whole.rows(), -1, 2);
  VectorX x = b;
  block.solve(x.data());
  return (whole * x - b).norm() / (whole.norm() * x.norm() + b.norm());
}

TEST(ChangingBlock, SolvesWithWhateverChangesTouch) {
  std::mt19937 random(41);
  for (int size : {1, 2, 7, 40}) {
    const MatrixX constant = random_definite(size);
    ChangingBlock block(constant);
    EXPECT_FALSE(block.covers(std::vector<char>(at(size), 0)));
    for (double part : {0.0, 0.3, 0.3, 1.0, 0.1}) {
      std::vector<char> touched(at(size)), more(at(size), 1);
      for (char& flag : touched) flag = std::uniform_real_distribution<double>(0, 1)(random) < part;
      block.condense(touched);
      EXPECT_TRUE(block.covers(touched));
      EXPECT_EQ(block.covers(more), touched == more);
      for (int round = 0; round < 3; ++round) {
        MatrixX whole = constant;
        std::vector<ChangingBlock::Change> changes;
        for (int j = 0; j < size; ++j)
          for (int i = 0; i < size; ++i)
            if (touched[at(i)] && touched[at(j)]) {
              changes.push_back({i, j, std::uniform_real_distribution<double>(0, 1e3)(random)});
              whole(i, j) += changes.back().value;
            }
        PivotRange pivots;
        block.factor(changes, pivots);
        EXPECT_TRUE(pivots.regular());
        EXPECT_LT(backward_error(block, whole), 1e-14) << size << " " << part;
      }
    }
  }
}

/// The untouched part may be singular by itself: then all is factored at once.
TEST(ChangingBlock, SingularUnlessChanged) {
  // Two chains of ten unknowns with a spring of stiffness 1 between neighbours
  MatrixX constant = MatrixX::Zero(20, 20);
  for (int i = 0; i + 1 < 20; ++i)
    if (i != 9) constant.block<2, 2>(i, i) += (Eigen::Matrix2d() << 1, -1, -1, 1).finished();
  ChangingBlock block(constant);
  PivotRange none;
  block.condense(std::vector<char>(20, 0));
  block.factor({}, none);
  EXPECT_FALSE(none.regular());
  // Holding one chain leaves the other free.
  std::vector<char> touched(20, 0);
  std::vector<ChangingBlock::Change> changes;
  MatrixX whole = constant;
  for (int held : {4, 11}) {
    touched[at(held)] = 1;
    changes.push_back({held, held, 3.0});
    whole(held, held) += 3;
    EXPECT_FALSE(block.covers(touched));
    block.condense(touched);
    PivotRange pivots;
    block.factor(changes, pivots);
    EXPECT_EQ(pivots.regular(), held == 11);
  }
  EXPECT_LT(backward_error(block, whole), 1e-14);
}

TEST(PivotRange, KnowsSingularAndNotFinitePivots) {
  PivotRange pivots;
  EXPECT_TRUE(pivots.regular()); // of no unknowns
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

} // namespace changing_block_test
} // namespace signorini::solve
