#include "view/curves.hpp"

#include "scenes.hpp"
#include "svg.hpp"
#include "view/text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace signorini::view {
namespace inset_test {

const Style style = style_for({1600, 1000});

Frame chart_frame() {
  Frame frame;
  frame.box = {150, 1350, 110, 930};
  frame.x = {0, 1, false, 150, 1350};
  frame.y = {0, 1, false, 110, 930};
  return frame;
}

/// A zigzag over x = 0 … 1 that avoids one corner: up to 0.4 on its side, anywhere else.
Series zigzag(Corner free, std::mt19937& random) {
  std::uniform_real_distribution<double> part(0, 1);
  const bool east = free == Corner::north_east || free == Corner::south_east;
  const bool north = free == Corner::north_east || free == Corner::north_west;
  Series s;
  for (int i = 0; i <= 60; ++i) {
    const double x = i / 60.0, height = x > 0.4 ? 0.4 * part(random) : part(random);
    s.x.push_back(east ? x : 1 - x);
    s.y.push_back(north ? height : 1 - height);
  }
  return s;
}

bool holds_box(const Box& outer, const Box& inner) {
  return inner[0] >= outer[0] && inner[1] <= outer[1] && inner[2] >= outer[2] && inner[3] <= outer[3];
}

/// The area of an inset's frame and numbers.
Box taken_by(const Frame& frame, const Style& small) {
  Box box = frame.box;
  box[0] -= room_left(small, frame.yticks, "");
  box[2] -= room_below(small, "");
  for (std::size_t i = 0; i < frame.xticks.at.size(); ++i)
    box[1] = std::max(box[1], frame.x(frame.xticks.at[i]) + 0.5 * text_width(frame.xticks.labels[i], small.tick_size));
  if (!frame.yticks.factor.empty()) box[3] += 1.1 * small.tick_size;
  return box;
}

TEST(Inset, CoversNoCurveInAFreeCornerAndIsNeverClipped) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> start(0.05, 0.85), exponent(-7, 7);
  const Frame chart = chart_frame();
  for (int trial = 0; trial < 200; ++trial) {
    const Corner free = static_cast<Corner>(trial % 4);
    std::vector<Series> series = {zigzag(free, random), zigzag(free, random)};
    ChartOptions options;
    const double from = free == Corner::north_east || free == Corner::south_east ? 0.1 : 0.85;
    options.inset = Inset{{from, from + 0.05}};
    const PlacedInset inset = place_inset(series, options, chart, style);
    EXPECT_EQ(inset.hidden, 0);
    EXPECT_EQ(covered(lines_of(series, chart, style), inset.outer), 0);
    EXPECT_FALSE(overlap(inset.outer, inset.marked));
    EXPECT_TRUE(holds_box(chart.box, inset.outer));
    EXPECT_TRUE(holds_box(chart.box, inset.marked));
    EXPECT_TRUE(holds_box(inset.outer, taken_by(inset.frame, inset.style)));
    EXPECT_GE(inset.outer[1] - inset.outer[0], 0.3 * 1200 - 1e-9);
  }
}

TEST(Inset, CoversLeastWithoutFreeCornerAndFollowsItsPlace) {
  std::mt19937 random(22);
  Series everywhere = zigzag(Corner::north_east, random);
  Series other = zigzag(Corner::south_west, random);
  ChartOptions options;
  options.inset = Inset{{0.45, 0.5}};
  const std::vector<Series> series = {everywhere, other};
  const PlacedInset best = place_inset(series, options, chart_frame(), style);
  EXPECT_GT(best.hidden, 0);
  for (Corner corner : {Corner::north_east, Corner::north_west, Corner::south_east, Corner::south_west}) {
    options.inset->place = corner;
    const PlacedInset inset = place_inset(series, options, chart_frame(), style);
    EXPECT_GE(inset.hidden, best.hidden);
    const bool east = corner == Corner::north_east || corner == Corner::south_east;
    const bool north = corner == Corner::north_east || corner == Corner::north_west;
    EXPECT_EQ(0.5 * (inset.outer[0] + inset.outer[1]) > 750, east);
    EXPECT_EQ(0.5 * (inset.outer[2] + inset.outer[3]) > 520, north);
  }
}

TEST(Inset, ShowsTheYRangeOfTheCurvesOrTheGivenOne) {
  Series line{"", {0, 1}, {0, 1}};
  ChartOptions options;
  options.inset = Inset{{0.2, 0.4}};
  const Frame frame = place_inset({line}, options, chart_frame(), style).frame;
  EXPECT_NEAR(frame.y.low, 0.2 - 0.08 * 0.2, 1e-12);
  EXPECT_NEAR(frame.y.high, 0.4 + 0.08 * 0.2, 1e-12);
  EXPECT_EQ(frame.x.low, 0.2);
  options.inset->yrange = {0, 0.5};
  EXPECT_EQ(place_inset({line}, options, chart_frame(), style).frame.y.high, 0.5);
}

TEST(Inset, RejectsRegionsWithoutData) {
  Series line{"", {0, 1}, {0, 1}};
  ChartOptions options;
  const auto refusal = [&](const Inset& inset) {
    options.inset = inset;
    return message_of([&] { place_inset({line}, options, chart_frame(), style); });
  };
  EXPECT_TRUE(holds(refusal({{3, 4}}), {"view.inset.no_curve: low = 3, high = 4"}));
  EXPECT_TRUE(holds(refusal({{0.2, 0.4}, {{7, 8}}}), {"view.inset.outside_chart"}));
}

/// Sines so dense that no corner is free.
std::vector<Series> full_chart() {
  std::vector<Series> series(3);
  for (int n = 0; n < 3; ++n)
    for (int i = 0; i <= 300; ++i) {
      series[n].x.push_back(i);
      series[n].y.push_back(2 + std::sin(i / 3.0 + n));
    }
  return series;
}

TEST(Inset, ExtendsTheChartWithoutFreeCorner) {
  const auto drawn_with = [](const ChartOptions& options) { return chart_of(full_chart(), options); };
  ChartOptions options;
  EXPECT_FALSE(holds(drawn_with(options), {">4.0<"}));
  options.inset = Inset{{100, 120}};
  EXPECT_TRUE(holds(drawn_with(options), {">4.0<", ">105<"})); // the axis is extended to 4, and the inset has numbers
  options.inset->place = Corner::south_west;
  EXPECT_TRUE(holds(drawn_with(options), {">0.0<"}));
  options.yrange = {1, 3};
  EXPECT_FALSE(holds(drawn_with(options), {">0.0<"}));
  options.yrange.reset();
  options.log_y = true;
  EXPECT_TRUE(holds(drawn_with(options), {">105<"}));
}

TEST(Inset, IsDrawnInEveryFormat) {
  for (const Format format : {Format::png, Format::svg, Format::pdf}) {
    ChartOptions options;
    const std::string plain = chart_of(oscillating_forces(3), options, format);
    options.inset = Inset{{100, 120}};
    const std::string inset = chart_of(oscillating_forces(3), options, format);
    EXPECT_EQ(inset, chart_of(oscillating_forces(3), options, format)) << static_cast<int>(format);
    EXPECT_NE(inset, plain) << static_cast<int>(format);
  }
}

} // namespace inset_test
} // namespace signorini::view
