#include "view/curves.hpp"

#include "svg.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace signorini::view {
namespace bands_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
const Style style = style_for({1600, 1000});

Series curve_of(std::vector<double> x, std::vector<double> y, std::vector<double> error) {
  Series s;
  s.x = std::move(x);
  s.y = std::move(y);
  s.error = std::move(error);
  return s;
}

/// Ten pixels per unit; y from −10 to 10, or from 0.1 to 10 with 50 pixels per decade.
Frame frame_of(bool log_y) {
  Frame frame;
  frame.box = {0, 100, 100, log_y ? 200.0 : 300.0};
  frame.x = {0, 10, false, 0, 100};
  frame.y = {log_y ? 0.1 : -10.0, 10, log_y, frame.box[2], frame.box[3]};
  return frame;
}

/// The bands of curves; checks that all of them are below all curves and inside the frame.
std::vector<Fill> bands_of(const std::vector<Series>& series, bool log_y = false) {
  Drawing drawing{{1600, 1000}, {}};
  const Frame frame = frame_of(log_y);
  draw_series(drawing, series, frame, style);
  std::vector<Fill> found;
  bool curves = false;
  for (const Mark& mark : drawing.marks) {
    const Fill* fill = std::get_if<Fill>(&mark);
    const bool band = fill && fill->opacity < 1;
    EXPECT_FALSE(band && curves) << "a curve is below a band";
    curves = curves || !band;
    if (!band) continue;
    for (const Vec2& p : fill->outline) EXPECT_TRUE(holds(enlarged(frame.box, 1e-6), p)) << p[0] << ", " << p[1];
    found.push_back(*fill);
  }
  return found;
}

double area(const std::vector<Vec2>& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return std::abs(twice) / 2;
}

TEST(Bands, AreBelowAllCurvesInTheirColors) {
  const auto bands = bands_of({curve_of({0, 5, 10}, {1, 2, 3}, {1, 2, 1}), curve_of({0, 10}, {2, 2}, {1, 1})});
  ASSERT_EQ(bands.size(), 2u);
  EXPECT_EQ(bands[0].color, curve_colors()[0]);
  EXPECT_EQ(bands[1].color, curve_colors()[1]);
  const std::vector<Vec2> outline = {{0, 220}, {50, 240}, {100, 240}, {100, 220}, {50, 200}, {0, 200}};
  EXPECT_EQ(bands[0].outline, outline);
  EXPECT_TRUE(bands_of({curve_of({0, 10}, {1, 2}, {})}).empty());
}

TEST(Bands, HaveGapsWhereErrorOrCurveIsUnknown) {
  const std::vector<double> x = {0, 2, 4, 6, 8, 10}, y = {1, 1, 1, 1, 1, 1};
  for (const double unknown : {nan, inf}) {
    const auto bands = bands_of({curve_of(x, y, {1, 1, unknown, 1, 1, 1})});
    ASSERT_EQ(bands.size(), 2u);
    EXPECT_DOUBLE_EQ(area(bands[0].outline), 20 * 20);
    EXPECT_DOUBLE_EQ(area(bands[1].outline), 40 * 20);
    EXPECT_EQ(bands_of({curve_of(x, {1, 1, 1, unknown, 1, 1}, {1, 1, 1, 1, 1, 1})}).size(), 2u);
    EXPECT_TRUE(bands_of({curve_of(x, y, std::vector(6, unknown))}).empty());
  }
  const auto isolated = bands_of({curve_of(x, y, {nan, nan, 1, nan, nan, nan})});
  ASSERT_EQ(isolated.size(), 1u);
  EXPECT_DOUBLE_EQ(area(isolated[0].outline), 16 * 20); // as wide as a marker
}

TEST(Bands, AreClippedToTheAxes) {
  // The upper edge rises from 0 to 20 and leaves the axes in the middle, the lower one falls.
  const auto bands = bands_of({curve_of({0, 10}, {0, 0}, {0, 20})});
  ASSERT_EQ(bands.size(), 1u);
  EXPECT_NEAR(area(bands[0].outline), 100 * 200 - 2 * 50 * 100 / 2, 1e-9);
  const auto beyond = bands_of({curve_of({-5, 15}, {0, 0}, {1, 1})});
  ASSERT_EQ(beyond.size(), 1u);
  EXPECT_NEAR(area(beyond[0].outline), 100 * 20, 1e-9);
  EXPECT_TRUE(bands_of({curve_of({0, 10}, {15, 15}, {1, 1})}).empty());
  const auto huge = bands_of({curve_of({0, 5, 10}, {0, 0, 0}, {1, 1e308, 1})}); // neighbors are not affected
  ASSERT_EQ(huge.size(), 1u);
  EXPECT_NEAR(area(huge[0].outline), 100 * 200, 0.1);
}

TEST(Bands, EndAtTheLowerLimitOfALogarithmicAxis) {
  const auto bands = bands_of({curve_of({0, 10}, {1, 1}, {0.9, 1})}, true);
  ASSERT_EQ(bands.size(), 1u);
  EXPECT_NEAR(area(bands[0].outline), 100 * 50 * (1 + 0.5 * std::log10(1.9 * 2)), 1e-9);
  EXPECT_TRUE(bands_of({curve_of({0, 10}, {0.01, 0.01}, {0.02, 0.02})}, true).empty()); // wholly below the axis
}

TEST(Bands, ArePartedWhereTheCurveTurnsBack) {
  const auto bands = bands_of({curve_of({0, 5, 10, 10, 4}, {0, 0, 0, 0.5, 0.5}, {1, 1, 1, 1, 1})});
  ASSERT_EQ(bands.size(), 2u);
  EXPECT_NEAR(area(bands[0].outline), 100 * 20, 1e-9);
  EXPECT_NEAR(area(bands[1].outline), 60 * 20, 1e-9);
}

TEST(Bands, CountAsLinesThatALegendAvoids) {
  const Series s = curve_of({0, 10}, {0, 0}, {5, 5});
  EXPECT_GT(covered(lines_of({s}, frame_of(false), style), {80, 90, 240, 260}), 0);
}

TEST(Bands, ExtendTheRangeByAtMostTheSpanOfTheCurves) {
  const auto range = [](const std::vector<double>& y, const std::vector<double>& error, bool log_y = false) {
    std::vector<double> x;
    for (std::size_t i = 0; i < y.size(); ++i) x.push_back(static_cast<double>(i));
    const Range found = range_within({curve_of(x, y, error)}, {0, x.back()}, false, log_y);
    return std::array{found.low, found.high};
  };
  using Ends = std::array<double, 2>;
  EXPECT_EQ(range({1, 2, 4}, {0.5, 0.5, 1}), (Ends{0.5, 5}));
  EXPECT_EQ(range({1, 2, 4}, {inf, nan, inf}), (Ends{1, 4}));
  EXPECT_EQ(range({1, 2, 4}, {0, 1e300, 0}), (Ends{-1, 5}));
  EXPECT_EQ(range({5, 5}, {1, 2}), (Ends{3, 7})); // constant: up to the value
  EXPECT_EQ(range({5, 5}, {1, 1e300}), (Ends{0, 10}));
  EXPECT_EQ(range({0, 0}, {1, 2}), (Ends{-2, 2}));
  const auto [low, high] = range({0.01, 1, 100}, {0.02, 0.1, 50}, true); // a decade below the lowest value
  EXPECT_NEAR(low, 0.001, 1e-12);
  EXPECT_NEAR(high, 150, 1e-9);
  // A band that lies only partly within the range of x counts with its part there.
  EXPECT_DOUBLE_EQ(range_within({curve_of({0, 2}, {0, 1}, {0.25, 0.25})}, {0, 1}, false, false).high, 0.75);
}

TEST(ClipPolygon, KeepsThePartOfATriangleInsideTheBox) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> coordinate(-2, 3);
  const Box box = {0, 1, -1, 2};
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Vec2> triangle;
    for (int k = 0; k < 3; ++k) triangle.push_back({coordinate(random), coordinate(random)});
    const auto side = [&](int k, const Vec2& p) {
      const Vec2 along = triangle[(k + 1) % 3] - triangle[k], to = p - triangle[k];
      return along[0] * to[1] - along[1] * to[0] > 0;
    };
    constexpr int n = 400;
    int inside = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const Vec2 p = {(i + 0.5) / n, -1 + 3 * (j + 0.5) / n};
        inside += side(0, p) == side(1, p) && side(1, p) == side(2, p);
      }
    EXPECT_NEAR(area(clip_polygon(triangle, box)), 3.0 * inside / (n * n), 2e-2);
  }
}

} // namespace bands_test
} // namespace signorini::view
