#include "view/frame.hpp"
#include "view/text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace signorini::view {
namespace ticks_test {

using Labels = std::vector<std::string>;

TEST(LinearTicks, AreRoundNumbersWithEqualDecimals) {
  EXPECT_EQ(linear_ticks(0, 1, 6).labels, (Labels{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(linear_ticks(-0.27, 0.12, 5).labels, (Labels{"−0.2", "−0.1", "0.0", "0.1"}));
  EXPECT_EQ(linear_ticks(0, 296, 9).labels, (Labels{"0", "50", "100", "150", "200", "250"}));
}

TEST(LinearTicks, TerminateForARangeAsNarrowAsRoundingError) {
  EXPECT_LE(linear_ticks(99.99999999999986, 100, 9).at.size(), 10U);
  EXPECT_LE(linear_ticks(1, 1 + 4e-16, 9).at.size(), 10U);
  EXPECT_LE(log_ticks(99.99999999999986, 100, 9).at.size(), 10U);
}

TEST(LinearTicks, ShareAPowerOfTenForLargeAndSmallNumbers) {
  const Ticks large = linear_ticks(0, 2.4e6, 6);
  EXPECT_EQ(large.factor, "×10⁶");
  EXPECT_EQ(large.labels, (Labels{"0.0", "0.5", "1.0", "1.5", "2.0"}));
  EXPECT_EQ(linear_ticks(-3e-12, 1e-12, 6).factor, "×10⁻¹²");
  EXPECT_EQ(linear_ticks(0, 0.01, 6).factor, "");
}

TEST(LinearTicks, StayInTheRangeAndBelowTheCount) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(-20, 20), fraction(-1, 1);
  for (int trial = 0; trial < 2000; ++trial) {
    const double width = std::pow(10, exponent(random)), low = 50 * width * fraction(random), high = low + width;
    for (int count : {2, 5, 9}) {
      const Ticks ticks = linear_ticks(low, high, count);
      ASSERT_EQ(ticks.at.size(), ticks.labels.size());
      ASSERT_LE(static_cast<int>(ticks.at.size()), count);
      ASSERT_GE(static_cast<int>(ticks.at.size()), count / 3) << low << " " << high << " " << count;
      for (std::size_t i = 0; i < ticks.at.size(); ++i) {
        ASSERT_GE(ticks.at[i], low - 1e-8 * width);
        ASSERT_LE(ticks.at[i], high + 1e-8 * width);
        if (i > 0) {
          ASSERT_NE(ticks.labels[i], ticks.labels[i - 1]);
        }
      }
    }
  }
}

/// Ticks of at least `least` numbers on a scale do not overlap.
void expect_apart(const Scale& scale, std::size_t least) {
  const Style style = style_for({1600, 1000});
  const Ticks up = stacked_ticks(scale.low, scale.high, scale.log, scale.to, style),
              along = fitting_ticks(scale.low, scale.high, scale.log, scale.to, style);
  ASSERT_TRUE(along.at.size() >= least && (!scale.log || up.at.size() >= least)) << scale.low << " " << scale.high;
  for (std::size_t i = 1; i < up.at.size(); ++i)
    ASSERT_GE(scale(up.at[i]) - scale(up.at[i - 1]), 1.1 * style.tick_size);
  for (std::size_t i = 1; i < along.at.size(); ++i)
    ASSERT_GE(scale(along.at[i]) - scale(along.at[i - 1]),
              0.5 * (text_width(along.labels[i - 1], style.tick_size) + text_width(along.labels[i], style.tick_size)));
}

TEST(FrameTicks, DoNotOverlapOnLogAxesOfAnySpan) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> size(300, 1400), exponent(-12, 9), width(0.02, 6);
  for (int trial = 0; trial < 1000; ++trial) {
    const double pixels = size(random), low = std::pow(10, exponent(random));
    expect_apart({low, low * std::pow(10, width(random)), true, 0, pixels}, 2);
  }
}

TEST(LogTicks, ArePowersOfTenWithMinorTicksAtTheirMultiples) {
  const Ticks ticks = log_ticks(0.5, 200, 9);
  EXPECT_EQ(ticks.labels, (Labels{"10⁰", "10¹", "10²"}));
  EXPECT_EQ(ticks.minor.front(), 0.5);
  EXPECT_EQ(ticks.minor.back(), 200);
  EXPECT_EQ(log_ticks(1e-12, 1e6, 7).labels, (Labels{"10⁻¹²", "10⁻⁹", "10⁻⁶", "10⁻³", "10⁰", "10³", "10⁶"}));
}

TEST(FrameTicks, DoNotOverlapOnAxesOfAnyLength) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> size(8, 900), exponent(-6, 6), fraction(-1, 1);
  for (int trial = 0; trial < 1000; ++trial) {
    const double pixels = size(random), width = std::pow(10, exponent(random)), low = 3 * width * fraction(random);
    expect_apart({low, low + width, false, 0, pixels}, 1);
  }
}

TEST(LogTicks, ShowMultiplesIfFewPowersAreInTheRange) {
  EXPECT_EQ(log_ticks(0.015, 0.6, 9).labels, (Labels{"0.02", "0.05", "0.1", "0.2", "0.5"}));
  EXPECT_EQ(log_ticks(1.5e-7, 9e-7, 9).labels, (Labels{"2×10⁻⁷", "5×10⁻⁷"}));
  EXPECT_EQ(log_ticks(3.1, 4.4, 5).labels, (Labels{"3.5", "4.0"}));
  EXPECT_EQ(log_ticks(0.9, 12, 9).labels, (Labels{"1", "2", "5", "10"}));
  EXPECT_EQ(log_ticks(0.9, 12, 3).labels, (Labels{"10⁰", "10¹"})); // if more do not fit
}

TEST(LogTicks, HaveMinorTicksWithinAnyRangeOnly) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> exponent(-9, 9), width(0.01, 3);
  for (int trial = 0; trial < 2000; ++trial) {
    const double low = std::pow(10, exponent(random)), high = low * std::pow(10, width(random));
    const Ticks ticks = log_ticks(low, high, 9);
    ASSERT_GE(ticks.at.size(), 2u) << low << " " << high;
    ASSERT_GE(ticks.minor.size(), 2u) << low << " " << high;
    for (double v : ticks.minor) {
      ASSERT_TRUE(v >= low * (1 - 1e-8) && v <= high * (1 + 1e-8)) << v;
      for (double major : ticks.at) ASSERT_GT(std::abs(v - major), 1e-6 * v);
    }
  }
  EXPECT_EQ(log_ticks(3.1, 4.4, 5).minor.size(), 12u); // 3.1, 3.2 … 4.4 without 3.5 and 4.0
}

} // namespace ticks_test
} // namespace signorini::view
