#include "view/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::view {
namespace ruler_test {

TEST(Digits, AreAtMostThree) {
  EXPECT_EQ(in_digits(850), "850");
  EXPECT_EQ(in_digits(-0.25), "−0.25");
  EXPECT_EQ(in_digits(-1.319e-7), "−1.32×10^{-7}");
  EXPECT_EQ(in_digits(2e6), "2×10^{6}");
  EXPECT_EQ(in_digits(0), "0");
}

/// A round length, drawn to scale, at most a fifth of the frame's width.
TEST(Ruler, HasTheLengthOfItsLabel) {
  const Style style = style_for({1600, 1000});
  for (double width = 1e-4; width < 1e5; width *= 1.7) {
    Drawing drawing{{1600, 1000}, {}};
    const Scale scale{-width / 3, 2 * width / 3, false, 100, 1100};
    draw_ruler(drawing, {100, 50}, scale, "mm", style);
    ASSERT_EQ(drawing.marks.size(), 4u);
    const auto& line = std::get<Stroke>(drawing.marks[0]).points;
    const double length = (line[1][0] - line[0][0]) / 1000 * width;
    EXPECT_LE(length, 0.2 * width * (1 + 1e-12));
    EXPECT_GE(length, 0.08 * width * (1 - 1e-12));
    const double lead = length / std::pow(10, std::floor(std::log10(length * (1 + 1e-9))));
    EXPECT_LT(std::min({std::abs(lead - 1), std::abs(lead - 2), std::abs(lead - 5)}), 1e-9) << width;
    EXPECT_EQ(std::get<Text>(drawing.marks[3]).string, in_digits(length) + " mm");
  }
}

} // namespace ruler_test
} // namespace signorini::view
