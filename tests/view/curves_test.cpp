#include "view/curves.hpp"
#include "view/legend.hpp"

#include "svg.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace signorini::view {
namespace curves_test {

const Style style = style_for({1600, 1000});

Series points_of(std::vector<double> x, std::vector<double> y) {
  Series s;
  s.x = std::move(x);
  s.y = std::move(y);
  return s;
}

std::vector<Series> labeled(int count) {
  std::vector<Series> series(count, points_of({0, 1}, {0, 1}));
  for (int n = 0; n < count; ++n) series[n].label = text("N", n);
  return series;
}

TEST(Look, DistinguishesSixteenSeriesByLinesAndByMarkers) {
  const auto series = labeled(16);
  for (std::size_t a = 0; a < series.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const CurveLook one = look_of(series, a, style), other = look_of(series, b, style);
      EXPECT_FALSE(one.color == other.color && one.dash == other.dash) << a << " " << b;
      EXPECT_NE(one.marker, other.marker) << a << " " << b;
    }
}

TEST(Look, FollowsColorMarkerAndDashes) {
  auto series = labeled(3);
  series[2].color = 0;
  EXPECT_EQ(look_of(series, 2, style), look_of(series, 0, style));
  series[2].dashed = true;
  EXPECT_FALSE(look_of(series, 2, style) == look_of(series, 0, style));
  EXPECT_EQ(look_of(series, 2, style).color, look_of(series, 0, style).color);
  series[1].marker = no_marker;
  EXPECT_EQ(look_of(series, 1, style).marker, no_marker);
  EXPECT_EQ(look_of(labeled(1), 0, style).marker, no_marker); // not needed for a single line
}

TEST(Look, OfGrayIsNeutralWithoutMarkers) {
  auto series = labeled(3);
  series[0].color = gray;
  EXPECT_EQ(look_of(series, 0, style).color, gray_color);
  EXPECT_EQ(look_of(series, 0, style).marker, no_marker);
  EXPECT_TRUE(look_of(series, 0, style).dash.empty());
  series[0].markers = true;
  EXPECT_EQ(look_of(series, 0, style).marker, 0);
}

TEST(Legend, ListsCurvesThenPointKindsWithTitles) {
  auto series = labeled(2);
  for (Series& s : series) s.marks = {0, 1};
  ChartOptions options;
  options.marks = {"m1", "m2"};
  options.legend_title = "order";
  options.marks_title = "mesh";
  const Legend legend = make_legend(series, options, style, 900);
  std::vector<std::string> labels;
  for (const Legend::Row& row : legend.rows) labels.push_back(row.label);
  EXPECT_EQ(labels, (std::vector<std::string>{"order", "N0", "N1", "", "mesh", "m1", "m2"}));
  EXPECT_EQ(legend.rows[2].series, 1u);
  EXPECT_EQ(legend.rows[6].mark, 1);
  EXPECT_FALSE(legend.rows[4].series || legend.rows[4].mark);
  EXPECT_EQ(look_of(series, 1, style).marker, no_marker); // the curve in the legend has no marker of its own
  series.resize(1);
  series[0].label.clear();
  EXPECT_EQ(make_legend(series, options, style, 900).rows.size(), 3u); // a single curve needs no name, its points do
}

TEST(Legend, IsLegibleForSixteenCurvesAndEightPointKinds) {
  ChartOptions options;
  options.legend_title = options.marks_title = "title";
  for (int k = 0; k < 8; ++k) options.marks.push_back(text("mesh ", k));
  const Legend legend = make_legend(labeled(17), options, style, 860);
  EXPECT_EQ(legend.height, 0);                                                          // next to the chart
  for (const Legend::Row& row : legend.rows) EXPECT_GE(row.text.size, 18) << row.label; // numbers have 27
  const double swatches = 2 * 1.06 * 8 * 1.3;
  EXPECT_GE(legend.row, swatches); // markers do not overlap
}

TEST(Legend, HasOneRowPerLabelAndLook) {
  auto series = labeled(4);
  series[2].label = series[0].label;
  EXPECT_EQ(make_legend(series, {}, style, 900).rows.size(), 4u); // a different color gets a row
  series[2].color = 0;
  const Legend legend = make_legend(series, {}, style, 900);
  ASSERT_EQ(legend.rows.size(), 3u);
  EXPECT_EQ(legend.rows[2].label, "N3");
  series[2].markers = series[2].dashed = true;
  EXPECT_EQ(make_legend(series, {}, style, 900).rows.size(), 4u);
}

TEST(Legend, IsInTheFirstFreeCornerOfTheChart) {
  const Box frame = {100, 1500, 100, 900};
  const auto corner_of = [&](const Lines& lines, bool always) -> std::string {
    const auto legend = legend_within(labeled(2), {}, frame, lines, always, style);
    if (!legend) return "none";
    const Box& box = *legend->within;
    EXPECT_TRUE(box[0] > frame[0] && box[1] < frame[1] && box[2] > frame[2] && box[3] < frame[3]);
    if (!always) {
      EXPECT_EQ(covered(lines, box), 0);
    }
    return std::string(box[2] > 500 ? "north" : "south") + (box[0] > 800 ? "-east" : "-west");
  };
  const std::vector<Vec2> rising = {{100, 100}, {1500, 900}}, falling = {{100, 900}, {1500, 100}};
  EXPECT_EQ(corner_of({}, false), "north-east");
  EXPECT_EQ(corner_of({rising}, false), "north-west");
  EXPECT_EQ(corner_of({falling}, false), "north-east");
  EXPECT_EQ(corner_of({rising, falling}, false), "none");
  EXPECT_NE(corner_of({rising, falling}, true), "none");
  EXPECT_FALSE(legend_within(labeled(30), {}, frame, {}, true, style)); // larger than half of the chart
}

TEST(RangeWithin, MatchesADenselySampledCurve) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> value(0.1, 10), gap(0.01, 1);
  for (int trial = 0; trial < 200; ++trial) {
    const bool log_x = trial % 2 == 1, log_y = trial % 4 >= 2;
    const auto bend = [](double v, bool log) { return log ? std::log(v) : v; };
    std::vector<double> x, y;
    for (double at = gap(random); x.size() < 12; at += gap(random)) x.push_back(at), y.push_back(value(random));
    if (trial % 3 == 0) y[5] = std::nan("");
    const double from = x[2] + 0.3 * (x[3] - x[2]), to = x[8] + 0.6 * (x[9] - x[8]);
    Range expected;
    for (std::size_t i = 1; i < x.size(); ++i)
      for (int k = 0; k <= 2000 && std::isfinite(y[i]) && std::isfinite(y[i - 1]); ++k) {
        const double t = k / 2000.0;
        const double across = (1 - t) * bend(x[i - 1], log_x) + t * bend(x[i], log_x);
        if (across < bend(from, log_x) || across > bend(to, log_x)) continue;
        const double up = (1 - t) * bend(y[i - 1], log_y) + t * bend(y[i], log_y);
        expected.take(log_y ? std::exp(up) : up);
      }
    const Range range = range_within({points_of(x, y)}, {from, to}, log_x, log_y);
    EXPECT_NEAR(range.low, expected.low, 1e-2 * expected.high);
    EXPECT_NEAR(range.high, expected.high, 1e-2 * expected.high);
    EXPECT_LE(range.low, expected.low + 1e-12);
    EXPECT_GE(range.high, expected.high - 1e-12);
  }
}

TEST(RangeWithin, IsEmptyOutsideTheCurveAndBetweenIsolatedMarkers) {
  Series s = points_of({0, 1}, {0, 10});
  EXPECT_TRUE(range_within({s}, {2, 3}, false, false).empty());
  EXPECT_DOUBLE_EQ(range_within({s}, {0.2, 0.4}, false, false).high, 4);
  s.line = false;
  s.markers = true;
  EXPECT_TRUE(range_within({s}, {0.2, 0.4}, false, false).empty());
}

TEST(Covered, IsTheLengthInside) {
  EXPECT_DOUBLE_EQ(covered({{{0, 0}, {10, 0}}, {{5, -3}, {5, 40}}}, {2, 6, -1, 1}), 6);
}

TEST(NamedTicks, ShrinkToFitSideBySide) {
  const std::vector<Name> labels = {
      {1, "N2"}, {2, "N2-N2.1"}, {3, "N2-N2.2x3"}, {4, "a long name of a mesh"}, {9, "far"}};
  const Scale scale{0.5, 4.5, false, 100, 740};
  const Ticks ticks = named_ticks(labels, scale, 300, style);
  ASSERT_EQ(ticks.labels.size(), 4u); // the last one is outside the axis
  EXPECT_LT(ticks.names[0].size, style.tick_size);
  EXPECT_EQ(named_ticks({{1, "m1"}, {2, "m2"}}, scale, 0, style).names[0].size, style.tick_size);
}

TEST(NamedTicks, WrapThenTurnUprightThenAreThinnedOut) {
  const std::vector<Name> labels = {{1, "m1"}, {2, "the second mesh"}, {3, "m3"}, {4, "m4"}};
  const auto ticks = [&](double wide, double most) {
    return named_ticks(labels, {0.5, 4.5, false, 0, wide}, most, style);
  };
  const Ticks wrapped = ticks(320, 300);
  EXPECT_FALSE(wrapped.upright);
  EXPECT_EQ(wrapped.names[0].size, style.tick_size);
  EXPECT_GT(wrapped.names[1].lines.size(), 1u);
  EXPECT_NEAR(wrapped.depth, wrapped.names[1].depth(), 1e-12);
  const Ticks upright = ticks(160, 300);
  EXPECT_TRUE(upright.upright);
  EXPECT_EQ(upright.names.size(), 4u);
  EXPECT_NEAR(upright.depth, upright.names[1].width() - style.tick_size, 1e-12);
  EXPECT_EQ(ticks(60, 300).names.size(), 2u); // 15 pixels apart, with at least 18 pixels each
  const Ticks level = ticks(160, 0);          // no space below: horizontal and truncated
  EXPECT_FALSE(level.upright);
  EXPECT_TRUE(level.names[1].cut);
  EXPECT_LE(level.names[1].width(), 40);
}

} // namespace curves_test
} // namespace signorini::view
