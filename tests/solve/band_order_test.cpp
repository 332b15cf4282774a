// The band that reordering leaves.
#include "solve/band_order.hpp"

#include "solve/matrices.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace signorini::solve {
namespace band_order_test {

using namespace test;

/// A grid of `wide` × `high` points, each coupled with its eight neighbours, numbered at random.
Pattern shuffled_grid(std::mt19937& random, int wide, int high) {
  std::vector<int> number(at(wide * high));
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), random);
  std::vector<std::vector<int>> groups;
  for (int y = 0; y + 1 < high; ++y)
    for (int x = 0; x + 1 < wide; ++x) {
      groups.emplace_back();
      for (int corner : {0, 1, wide, wide + 1}) groups.back().push_back(number[at(y * wide + x + corner)]);
    }
  return couple(wide * high, groups);
}

TEST(BandOrder, FindsTheBandOfAGridAlongItsLongSide) {
  std::mt19937 random(31);
  for (const auto& [wide, high] : {std::pair{2, 2}, {50, 2}, {60, 5}, {11, 80}}) {
    const Pattern pattern = shuffled_grid(random, wide, high);
    const std::vector<int> order = band_order(pattern);
    std::vector<int> sorted = order;
    std::sort(sorted.begin(), sorted.end());
    for (int i = 0; i < pattern.size; ++i) ASSERT_EQ(sorted[at(i)], i);
    // Column by column a point is coupled with the next column's second last: thickness + 1. Level by level from a
    // corner costs at most twice that.
    EXPECT_LE(band_width(pattern, order), 2 * std::min(wide, high) + 1) << wide << " " << high;
    EXPECT_GE(band_width(pattern, order), std::min(wide, high));
  }
}

TEST(BandOrder, PartsThatAreNotConnected) {
  std::mt19937 random(32);
  std::vector<std::vector<int>> pairs;
  for (int i = 0; i + 1 < 40; ++i)
    if (i != 19) pairs.push_back({(7 * i) % 40, (7 * i + 7) % 40});
  const Pattern pattern = couple(41, pairs); // two chains and one alone
  EXPECT_EQ(band_width(pattern, band_order(pattern)), 1);
  EXPECT_EQ(band_width(couple(3, {}), {2, 0, 1}), 0);
  EXPECT_TRUE(band_order(couple(0, {})).empty());
}

TEST(BandOrder, WidthIsThatOfTheReorderedMatrix) {
  const Pattern pattern = couple(4, {{0, 3}, {1, 2}});
  EXPECT_EQ(band_width(pattern, {0, 1, 2, 3}), 3);
  EXPECT_EQ(band_width(pattern, {0, 3, 1, 2}), 1);
}

} // namespace band_order_test
} // namespace signorini::solve
