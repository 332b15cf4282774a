// Color ranges and their outliers.
#include "view/colorbar.hpp"

#include "messages.hpp"

#include <gtest/gtest.h>

namespace signorini::view {
namespace color_range_test {

using Range = std::array<double, 2>;

/// 1000 values from 0 to 1.
VectorX smooth() {
  return VectorX::LinSpaced(1000, 0, 1);
}

TEST(ColorRange, SpansAllValuesWithoutOutliers) {
  VectorX values = smooth();
  values(7) = 3.9; // a stress concentration
  const auto range = colored_values({&values});
  EXPECT_FALSE(range->clipped());
  EXPECT_EQ(range->typical, (Range{0, 3.9}));
  EXPECT_FALSE(colored_values({}).has_value());
  const VectorX partly = Vec<3>(std::nan(""), 1, 3);
  EXPECT_EQ(colored_values({&partly})->all, (Range{1, 3}));
}

TEST(ColorRange, ExcludesASingleOutlierWithAWarning) {
  VectorX values = smooth();
  values(7) = 850;
  const auto range = colored_values({&values});
  EXPECT_EQ(range->extreme, 5u);
  EXPECT_EQ(range->count, 1000u);
  EXPECT_EQ(range->all, (Range{0, 850}));
  EXPECT_EQ(range->typical[0], 0);
  EXPECT_NEAR(range->typical[1], 1, 0.01);
  testing::internal::CaptureStderr();
  EXPECT_EQ(color_range(*range, {}, false, "stress"), range->typical);
  EXPECT_TRUE(test::holds(testing::internal::GetCapturedStderr(),
                          {"view.colors.outliers: title = stress, count = 5, samples = 1000, low = 0, high = 850"}));
}

TEST(ColorBar, PrintsMinimumAndMaximumAtItsEnds) {
  const auto texts = [](const Range& range, const Range& values) {
    Drawing drawing{{1600, 1000}, {}};
    draw_colorbar(drawing, {1300, 100, 900}, range, values, {black, white}, "stress", style_for({1600, 1000}));
    std::vector<std::string> found;
    for (const Mark& mark : drawing.marks)
      if (const Text* text = std::get_if<Text>(&mark); text && text->string.size() > 3 && text->string[0] == 'm') {
        found.push_back(text->string);
        EXPECT_EQ(text->at[0], 1300);
        EXPECT_EQ(text->at[1] > 500, text->string.substr(0, 3) == "max");
      }
    return found;
  };
  EXPECT_EQ(texts({0, 1}, {-1.319e-7, 850}), (std::vector<std::string>{"max 850", "min −1.32×10^{-7}"}));
  EXPECT_EQ(texts({0, 1}, {0, 0.25}), (std::vector<std::string>{"max 0.25", "min 0"}));
}

TEST(ColorBar, HasOneColorAndNoTicksForASingleValue) {
  const auto count = [](const Range& range) {
    Drawing drawing{{1600, 1000}, {}};
    draw_colorbar(drawing, {1300, 100, 900}, range, {2, 2}, {black, white}, "", style_for({1600, 1000}));
    int fills = 0, texts = 0;
    for (const Mark& mark : drawing.marks)
      fills += std::holds_alternative<Fill>(mark), texts += std::holds_alternative<Text>(mark);
    return std::array{fills, texts};
  };
  EXPECT_EQ(count(color_range(Range{2, 2}, {}, false)), (std::array{1, 2})); // min 2, max 2
  EXPECT_EQ(count({0, 4})[0], 2);
  EXPECT_GT(count({0, 4})[1], 4);
}

TEST(ColorBar, HasPointedEndsForValuesOutsideItsRange) {
  const auto points = [](const Range& values) {
    Drawing drawing{{1600, 1000}, {}};
    draw_colorbar(drawing, {1300, 100, 900}, {0, 1}, values, {black, white}, "stress", style_for({1600, 1000}));
    std::string found;
    for (const Mark& mark : drawing.marks)
      if (const Fill* fill = std::get_if<Fill>(&mark); fill && fill->outline.size() == 3)
        found += fill->outline[1][1] > 500 || fill->outline[2][1] > 500 ? "^" : "v";
    return found;
  };
  EXPECT_EQ(points({0, 850}), "^");
  EXPECT_EQ(points({-3, 0.5}), "v");
  EXPECT_EQ(points({0.1, 1}), "");
}

TEST(ColorRange, SpansAFieldThatIsZeroAlmostEverywhere) {
  VectorX values = VectorX::Zero(1000);
  values(7) = 1;
  EXPECT_EQ(colored_values({&values})->typical, (Range{0, 1}));
}

} // namespace color_range_test
} // namespace signorini::view
