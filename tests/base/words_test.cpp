#include "base/words.hpp"

#include <gtest/gtest.h>

namespace signorini {
namespace words_test {

TEST(Words, NumbersHaveSixDigits) {
  EXPECT_EQ(number(-0.125), "-0.125");
  EXPECT_EQ(number(1.0 / 3), "0.333333");
  EXPECT_EQ(number(12345678), "1.23457e+07");
  EXPECT_EQ(number(1), "1");
  EXPECT_EQ(number(1.2345678e-9), "1.23457e-09");
}

TEST(Words, CoordinatesAreInParentheses) {
  EXPECT_EQ(coordinates(Eigen::Vector2d(1.5, -2)), "(1.5, -2)");
  EXPECT_EQ(coordinates(Eigen::Vector3d(0, 1.0 / 3, 100)), "(0, 0.333333, 100)");
  EXPECT_EQ(coordinates(VectorX::Constant(1, 7)), "(7)");
}

TEST(Words, RoundingErrorIsPrintedAsZero) {
  EXPECT_EQ(coordinates(Eigen::Vector2d(1, -1e-16)), "(1, 0)");
  EXPECT_EQ(coordinates(Eigen::Vector2d(1, -0.0)), "(1, 0)");
  EXPECT_EQ(coordinates(Eigen::Vector2d(1, 1e-11)), "(1, 1e-11)");
  // Small coordinates are kept if no larger one exists.
  EXPECT_EQ(coordinates(Eigen::Vector2d(1e-16, -3e-16)), "(1e-16, -3e-16)");
  EXPECT_EQ(coordinates(Eigen::Vector2d::Zero()), "(0, 0)");
}

TEST(Words, CountOfOneIsSingular) {
  EXPECT_EQ(counted(0, "support"), "0 supports");
  EXPECT_EQ(counted(1, "support"), "1 support");
  EXPECT_EQ(counted(2, "support"), "2 supports");
}

} // namespace words_test
} // namespace signorini
