#include "base/window.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace signorini {
namespace window_test {

constexpr double pi = std::numbers::pi;

/// A square window for a picture of 1000 × 1000 pixels.
Window square(const Vec<2>& low, double side) {
  const auto axes = Mat<3>::Identity().topRows<2>();
  return box_window(axes, {low[0], low[1], 0}, {low[0] + side, low[1] + side, 0}, {1000, 1000});
}

/// An eighth of the unit circle, starting at the x-axis.
Vec<3> arc(double s, double) {
  return {std::cos(pi / 4 * s), std::sin(pi / 4 * s), 0};
}

TEST(Window, DividesAnArcUntilItsChordsAreWithinHalfAPixel) {
  for (double zoom : {1.0, 20.0, 1000.0}) {
    const double side = 1 / zoom, angle = 0.3;
    const Vec<2> middle(std::cos(angle), std::sin(angle));
    const Window window = square(middle - Vec<2>::Constant(0.5 * side), side);
    EXPECT_NEAR(window.pixel, side / 1000, 1e-15);
    std::vector<double> cuts = {0, 1};
    add_divisions(cuts, window_divisions(arc, {window}, false)[0]);
    int within = 0;
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      const double half = 0.5 * pi / 4 * (cuts[i] - cuts[i - 1]), at = pi / 4 * cuts[i];
      if (std::abs(at - angle) > 0.5 * side) continue;
      ++within;
      EXPECT_LT(1 - std::cos(half), 0.5 * window.pixel) << "zoom " << zoom; // sagitta of the chord
    }
    EXPECT_GE(within, zoom > 500 ? 1 : 3) << "zoom " << zoom;
    EXPECT_LT(cuts.size(), 100U) << "zoom " << zoom;
  }
}

TEST(Window, DoesNotDivideStraightOrInvisibleParts) {
  EXPECT_TRUE(window_divisions(arc, {}, false)[0].empty());
  EXPECT_TRUE(window_divisions(arc, {square({-1, -1}, 0.1)}, true)[0].empty());
  const auto straight = [](double s, double t) { return Vec<3>(s, t, 0); };
  EXPECT_TRUE(window_divisions(straight, {square({0.4, 0.4}, 0.1)}, false)[0].empty());
  // With varying colors: pieces of 1/16 of the window, 0.1/16 ≥ 2⁻⁸
  const auto colored = window_divisions(straight, {square({0.4, 0.4}, 0.1)}, true);
  double largest = 0;
  for (std::size_t i = 1; i < colored[0].size(); ++i)
    if (colored[0][i] > 0.4 && colored[0][i - 1] < 0.5) largest = std::max(largest, colored[0][i] - colored[0][i - 1]);
  EXPECT_DOUBLE_EQ(largest, std::exp2(-8));
  EXPECT_EQ(colored[0], colored[1]);
}

TEST(Window, ShowsABoxInSpaceAlongItsAxesAndReflected) {
  Eigen::Matrix<double, 2, 3> axes;
  axes << 0, 1, 0, 0, 0, 1; // from +x
  const Window window = box_window(axes, {5, 1, 2}, {6, 3, 8}, {100, 200});
  EXPECT_EQ(window.low, Vec<2>(1, 2));
  EXPECT_EQ(window.high, Vec<2>(3, 8));
  EXPECT_DOUBLE_EQ(window.pixel, 0.03);
  const Window image = mirrored(window, 1);
  EXPECT_EQ(image.axes * Vec<3>(7, -2, 4), window.axes * Vec<3>(7, 2, 4));
}

TEST(Window, MergesDivisionPointsWithoutDuplicates) {
  std::vector<double> fractions = even_cuts(4);
  add_divisions(fractions, {0.125, 0.5, 0.75 + 1e-12});
  EXPECT_EQ(fractions, (std::vector<double>{0, 0.125, 0.25, 0.5, 0.75, 1}));
}

} // namespace window_test
} // namespace signorini
