// What range colours span, and when extreme samples are left out.
#include "view/colorbar.hpp"

#include <gtest/gtest.h>

namespace signorini::view {
namespace color_range_test {

using Range = std::array<double, 2>;

/// 1000 values from 0 to 1.
VectorX smooth() {
  return VectorX::LinSpaced(1000, 0, 1);
}

TEST(ColorRange, SpansAllValuesOfAnOrdinaryField) {
  VectorX values = smooth();
  values(7) = 3.9; // a peak of stress
  const auto range = coloured_values({&values});
  EXPECT_FALSE(range->clipped());
  EXPECT_EQ(range->typical, (Range{0, 3.9}));
  EXPECT_FALSE(coloured_values({}).has_value());
}

TEST(ColorRange, LeavesOutOneExtremeSampleAndSaysSo) {
  VectorX values = smooth();
  values(7) = 850;
  const auto range = coloured_values({&values});
  EXPECT_EQ(range->extreme, 5u);
  EXPECT_EQ(range->count, 1000u);
  EXPECT_EQ(range->all, (Range{0, 850}));
  EXPECT_EQ(range->typical[0], 0);
  EXPECT_NEAR(range->typical[1], 1, 0.01);
  EXPECT_EQ(bar_title(*range, {}, "stress"), "stress (0 … 850)");
  EXPECT_EQ(bar_title(*range, Range{0, 2}, "stress"), "stress"); // the user's own range
  testing::internal::CaptureStderr();
  EXPECT_EQ(colour_range(*range, {}, false, "stress"), range->typical);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("the colors of 'stress' leave out 5 of 1000 samples, which "
                                                        "reach from 0 to 850"),
            std::string::npos);
}

TEST(ColorRange, KeepsAFieldThatIsZeroAlmostEverywhere) {
  VectorX values = VectorX::Zero(1000);
  values(7) = 1;
  EXPECT_EQ(coloured_values({&values})->typical, (Range{0, 1}));
}

} // namespace color_range_test
} // namespace signorini::view
