#include "view/chart.hpp"

#include "scenes.hpp"
#include "svg.hpp"

#include "view/curves.hpp"
#include "view/text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace signorini::view {
namespace chart_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

ChartOptions forces() {
  ChartOptions options;
  options.title = "2D frictional ironing, mesh m1";
  options.xlabel = "load step";
  options.ylabel = "force per unit depth";
  return options;
}

ChartOptions convergence() {
  ChartOptions options;
  options.xlabel = "degrees of freedom";
  options.ylabel = "relative error";
  options.log_x = options.log_y = true;
  return options;
}

Series line_of(std::vector<double> y) {
  Series s;
  for (std::size_t i = 0; i < y.size(); ++i) s.x.push_back(static_cast<double>(i));
  s.y = std::move(y);
  return s;
}

std::string refusal(const std::vector<Series>& series, const ChartOptions& options = {}) {
  return message_of([&] { chart_of(series, options); });
}

TEST(Chart, GivesEqualBytesForEqualCalls) {
  for (const Format format : {Format::png, Format::svg, Format::pdf})
    for (int kind = 0; kind < 2; ++kind) {
      const auto series = kind == 0 ? oscillating_forces(8) : convergence_lines();
      const auto options = kind == 0 ? forces() : convergence();
      const std::string first = chart_of(series, options, format);
      EXPECT_EQ(first, chart_of(series, options, format)) << static_cast<int>(format);
      EXPECT_GT(first.size(), 10000u);
    }
  EXPECT_EQ(png_size(chart_of(convergence_lines(), convergence(), Format::png)), (std::array<int, 2>{1600, 1000}));
}

TEST(Chart, KeepsTextAsTextInSvg) {
  const std::string svg = chart_of(oscillating_forces(8), forces());
  EXPECT_TRUE(
      holds(svg, {">2D frictional ironing, mesh m1<", ">load step<", ">force per unit depth<", ">N2-N2.3<", ">150<"}));
  EXPECT_TRUE(holds(chart_of(convergence_lines(), convergence()), {">10<tspan", ">−3</tspan>"}));
}

TEST(Chart, LeavesGapsForNonFinitePoints) {
  const auto polylines = [](std::vector<double> y) {
    return count_of(chart_of({line_of(std::move(y))}), "stroke:" + in_svg("#0072b2"));
  };
  EXPECT_EQ(polylines({1, 2, 3, 4, 5}), 1);
  EXPECT_EQ(polylines({1, 2, nan, 4, 5}), 2);
}

TEST(Chart, HasEightColorsAndALegendOutsideForEightSeries) {
  const std::string svg = chart_of(oscillating_forces(8), forces());
  for (const char* color : {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00"})
    EXPECT_TRUE(holds(svg, {in_svg(color)})) << color;
  ChartOptions bare = forces();
  bare.legend = LegendPlace::none;
  EXPECT_FALSE(holds(chart_of(oscillating_forces(8), bare), {">N2-N2.3<"}));
}

/// The filled shapes of an SVG, except its background.
const std::string filled = "stroke:none;fill-rule";

TEST(Chart, HasNamedTicksAndReferenceLines) {
  ChartOptions options;
  options.xticks = {{0, "m1"}, {1, "m2"}, {2, "m3"}, {4, "m5"}};
  const std::string named = chart_of({line_of({3, 2, 1})}, options);
  EXPECT_TRUE(holds(named, {">m1<", ">m2<", ">m3<", ">m5<"}));
  options.hlines = {{7, "analytic"}, {2, ""}};
  options.vlines = {{1.5, "a"}, {99, "beyond"}};
  options.xrange = {-1, 3};
  const std::string ruled = chart_of({line_of({3, 2, 1})}, options);
  EXPECT_TRUE(holds(ruled, {">analytic<", ">a<", ">7<"})); // y is extended up to the line
  EXPECT_FALSE(holds(ruled, {">beyond<"}));
  EXPECT_EQ(count_of(ruled, "stroke-dasharray"), 3);
}

/// The number after `key` in the element with this text.
double number_of(const std::string& svg, const std::string& text, const std::string& key) {
  return number_at(svg, ">" + text + "<", key);
}

TEST(Chart, PutsNamesOfCloseReferenceLinesNextToTheirLines) {
  ChartOptions options;
  options.hlines = {{0.5, "limit"}, {0.52, "limit 2"}};
  options.vlines = {{5, "five"}, {5.1, "five point one"}, {9, "end"}};
  options.yrange = {0, 1};
  options.xrange = {0.9, 9.1};
  options.legend = LegendPlace::none;
  const std::string svg = chart_of({Series{"", {1, 9}, {0, 1}}}, options);
  // Line positions from tick labels: y points downwards, and text centers are 0.36 font sizes above the baseline.
  const double size = style_for(options.size).tick_size;
  const auto across = [&](double y) {
    const double low = number_of(svg, "0.4", "y"), high = number_of(svg, "0.6", "y");
    return low + (y - 0.4) / 0.2 * (high - low) - 0.36 * size;
  };
  const auto along = [&](double x) {
    const double left = number_of(svg, "5", "x"), right = number_of(svg, "6", "x");
    return left + (x - 5) * (right - left);
  };
  EXPECT_GT(number_of(svg, "limit", "y"), across(0.5) + 0.5 * size); // below its line
  EXPECT_LT(number_of(svg, "limit 2", "y"), across(0.52));           // above its line
  EXPECT_LT(number_of(svg, "limit 2", "y"), number_of(svg, "limit", "y"));
  EXPECT_LT(number_of(svg, "five", "x"), along(5));
  EXPECT_GT(number_of(svg, "five point one", "x"), along(5.1));
  // No vertical line crosses the names of the horizontal ones.
  for (const char* name : {"limit", "limit 2"})
    for (const double x : {5.0, 5.1, 9.0}) {
      const double from = number_of(svg, name, "x"), to = from + text_width(name, number_of(svg, name, "font-size"));
      EXPECT_FALSE(from < along(x) && along(x) < to) << name << " at " << x;
    }
}

TEST(Chart, DrawsALeaderToAReferenceLineBetweenOthers) {
  ChartOptions options;
  options.hlines = {{0.49, "low"}, {0.5, "middle"}, {0.51, "high"}};
  options.yrange = {0, 1};
  const std::string svg = chart_of({line_of({1, 1})}, options);
  EXPECT_EQ(count_of(svg, filled), 1); // the dot at the middle line
  const double low = number_of(svg, "low", "y"), middle = number_of(svg, "middle", "y"),
               high = number_of(svg, "high", "y"), size = number_of(svg, "low", "font-size");
  EXPECT_GT(low, high + 1.5 * size);
  EXPECT_TRUE(middle < high + 0.3 * size || middle > low - 0.3 * size) << "it lies on the lines";
  options.hlines = {{0.2, "low"}, {0.5, "middle"}, {0.8, "high"}};
  EXPECT_EQ(count_of(chart_of({line_of({1, 1})}, options), filled), 0);
}

TEST(Chart, OmitsMarkersOnRequest) {
  Series first = line_of({1, 2, 3}), second = line_of({3, 2, 1});
  ChartOptions options;
  options.legend = LegendPlace::none;
  const auto polygons = [&] { return count_of(chart_of({first, second}, options), filled); };
  EXPECT_EQ(polygons(), 2 * 2 * 3); // several curves have markers, with rims
  first.markers = second.markers = false;
  EXPECT_EQ(polygons(), 0);
  second.markers = true;
  EXPECT_EQ(polygons(), 2 * 3);
}

TEST(Chart, DrawsArrowsInTheOrderOfPoints) {
  Series s = line_of({0, 0, 0, 0});
  ChartOptions options;
  options.yrange = {-1, 1};
  EXPECT_EQ(count_of(chart_of({s}, options), filled), 0);
  s.arrows = true;
  const std::string forth = chart_of({s}, options);
  const int heads = count_of(forth, filled);
  EXPECT_TRUE(heads >= 4 && heads <= 8) << heads;
  std::reverse(s.x.begin(), s.x.end());
  const std::string back = chart_of({s}, options);
  EXPECT_EQ(count_of(back, filled), heads);
  EXPECT_NE(back, forth);
}

TEST(Chart, DistinguishesFortyCurves) {
  const std::vector<Series> all(40, line_of({1, 2}));
  const Style style = style_for({1600, 1000});
  for (std::size_t a = 0; a < all.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const CurveLook one = look_of(all, a, style), other = look_of(all, b, style);
      EXPECT_TRUE(one.color != other.color || one.dash != other.dash) << a << " and " << b;
    }
  EXPECT_EQ(distinct_curves(), 40);
  testing::internal::CaptureStderr();
  chart_of(std::vector<Series>(41, line_of({1, 2})));
  EXPECT_TRUE(holds(testing::internal::GetCapturedStderr(), {"view.chart.many_curves: count = 41, distinct = 40"}));
}

TEST(Chart, MarksIsolatedPoints) {
  const double inf = std::numeric_limits<double>::infinity();
  const auto polygons = [&](const std::vector<double>& y) { return count_of(chart_of({line_of(y)}), filled); };
  EXPECT_EQ(polygons({1, 2, 3}), 0);
  EXPECT_EQ(polygons({1}), 2); // including its rim
  EXPECT_EQ(polygons({1, 2, nan, 3, inf, 4, 5}), 2);
  EXPECT_EQ(polygons({nan, 1, nan, 3, -inf}), 4);
}

TEST(Chart, PutsALegendWithLongNamesBelow) {
  std::vector<Series> series(3, line_of({1, 2, 3}));
  const auto legend = [&](const std::string& name, std::array<int, 2> size) {
    for (std::size_t n = 0; n < series.size(); ++n) series[n].label = name + " " + std::to_string(n);
    ChartOptions options;
    options.size = size;
    options.xlabel = "abscissa";
    return chart_of(series, options);
  };
  const std::string outside = legend("N2", {1600, 1000});
  EXPECT_LT(number_of(outside, "N2 0", "y"), 100);
  const std::string words = "a name that is too long to be next to the chart as it takes more than half of all space";
  const std::string below = legend(words, {1600, 1000});
  EXPECT_GT(number_of(below, words + " 0", "y"), number_of(below, "abscissa", "y"));
  EXPECT_GE(number_of(below, words + " 2", "font-size"), 18);
  EXPECT_TRUE(holds(legend(words + words, {900, 600}), {"…"}));
}

TEST(Chart, FitsTheYAxisToTheCurvesWithinXrange) {
  ChartOptions options;
  options.xrange = {0, 1};
  EXPECT_FALSE(holds(chart_of({line_of({1, 2, 500})}, options), {">500<"}));
  options.xrange = {8, 9};
  EXPECT_TRUE(holds(refusal({line_of({1, 2})}, options), {"view.chart.no_curve: low = 8, high = 9"}));
}

TEST(Chart, AppliesWidthMarkerAndColor) {
  Series s = line_of({1, 2, 3});
  s.width = 7;
  s.color = 1;
  EXPECT_TRUE(
      holds(chart_of({s}), {"stroke-width:7;stroke-linecap:butt;stroke-linejoin:round;stroke:" + in_svg("#d55e00")}));
  s.markers = true;
  s.marker = 0;
  const int fills = count_of(chart_of({s}), filled);
  s.marker = 8;
  EXPECT_EQ(count_of(chart_of({s}), filled), fills * 3 / 2); // each open marker is filled white
  s.marker = no_marker;
  EXPECT_EQ(count_of(chart_of({s}), filled), 0);
}

TEST(Chart, DrawsMarkersOfPointKindsInCurveColors) {
  ChartOptions options;
  options.marks = {"m1", "m2", "m3"};
  Series first = line_of({1, 2, 3}), second = line_of({3, 2, 1});
  first.label = "N2", second.label = "N4";
  first.marks = {0, 1, 2}, second.marks = {2, 1, 0};
  const std::string svg = chart_of({first, second}, options);
  EXPECT_EQ(count_of(svg, filled), 2 * (6 + 3)); // of points and of the legend, each with a white rim
  EXPECT_EQ(count_of(svg, ";fill:" + in_svg("#0072b2")), 3);
  EXPECT_EQ(count_of(svg, ";fill:" + in_svg("#d55e00")), 3);
  EXPECT_TRUE(holds(svg, {">N2<", ">N4<", ">m1<", ">m3<"}));
  options.marks.resize(17);
  EXPECT_TRUE(holds(refusal({first}, options), {"view.chart.kinds: count = 17, most = 16"}));
}

TEST(Chart, AcceptsConstantDataAndSinglePoints) {
  Series point = line_of({0});
  point.markers = true;
  for (const Series& series : {line_of({2, 2, 2}), point}) EXPECT_EQ(refusal({series}), "no error");
  EXPECT_EQ(refusal({Series{"", {10}, {1e-3}, true, true}}, convergence()), "no error");
}

TEST(Chart, RejectsInvalidInput) {
  EXPECT_TRUE(holds(refusal({line_of({nan, nan})}), {"view.chart.no_point"}));
  EXPECT_TRUE(holds(refusal({line_of({1, 2})}, convergence()),
                    {"view.chart.log: series = (view.chart.series: number = 0), axis = x, value = 0"}));
  ChartOptions negative;
  negative.log_y = true;
  negative.yrange = {-1, 1};
  EXPECT_TRUE(holds(refusal({line_of({1, 2})}, negative), {"view.axis.range_log: axis = y, low = -1, high = 1"}));
  ChartOptions falling;
  falling.xticks = {{2, "m2"}, {1, "m1"}};
  EXPECT_TRUE(
      holds(refusal({line_of({1, 2})}, falling), {"view.chart.ticks: name = m1, at = 1, before = m2, at_before = 2"}));
  ChartOptions zero;
  zero.log_y = true;
  zero.hlines = {{0, "nothing"}};
  EXPECT_TRUE(
      holds(refusal({line_of({1, 2})}, zero), {"view.chart.place_log: what = line, name = nothing, axis = y, at = 0"}));
  ChartOptions tiny;
  tiny.size = {40, 30};
  EXPECT_TRUE(holds(refusal({line_of({1, 2})}, tiny), {"view.frame.size: width = 40, height = 30"}));
}

} // namespace chart_test
} // namespace signorini::view
