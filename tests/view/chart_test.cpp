#include "view/chart.hpp"

#include "messages.hpp"
#include "scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

namespace signorini::view {
namespace {

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

std::string refusal(const std::vector<Series>& series, const ChartOptions& options = {},
                    const std::string& name = "no.png") {
  const std::string message = message_of([&] { draw_chart(series, options, scratch(name)); });
  EXPECT_FALSE(std::filesystem::exists(scratch(name)));
  return message;
}

TEST(Chart, GivesTheSameBytesForTheSameCall) {
  for (const std::string ending : {".png", ".svg", ".pdf"})
    for (int kind = 0; kind < 2; ++kind) {
      const auto series = kind == 0 ? oscillating_forces(8) : convergence_lines();
      const auto options = kind == 0 ? forces() : convergence();
      draw_chart(series, options, scratch("first" + ending));
      draw_chart(series, options, scratch("second" + ending));
      EXPECT_EQ(file_bytes(scratch("first" + ending)), file_bytes(scratch("second" + ending))) << ending;
      EXPECT_GT(file_bytes(scratch("first" + ending)).size(), 10000u);
    }
  EXPECT_EQ(png_size(file_bytes(scratch("first.png"))), (std::array<int, 2>{1600, 1000}));
}

TEST(Chart, KeepsTextAsTextInSvg) {
  draw_chart(oscillating_forces(8), forces(), scratch("text.svg"));
  const std::string svg = file_bytes(scratch("text.svg"));
  EXPECT_TRUE(
      holds(svg, {">2D frictional ironing, mesh m1<", ">load step<", ">force per unit depth<", ">N2-N2.3<", ">150<"}));
  draw_chart(convergence_lines(), convergence(), scratch("log.svg"));
  EXPECT_TRUE(holds(file_bytes(scratch("log.svg")), {">10<tspan", ">−3</tspan>"}));
}

TEST(Chart, LeavesGapsForPointsThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto polylines = [](const std::string& file) {
    const std::string svg = file_bytes(file);
    int count = 0;
    for (std::size_t at = svg.find("#0072b2\" stroke"); at != std::string::npos;
         at = svg.find("#0072b2\" stroke", at + 1))
      ++count;
    return count;
  };
  draw_chart({line_of({1, 2, 3, 4, 5})}, {}, scratch("one.svg"));
  draw_chart({line_of({1, 2, nan, 4, 5})}, {}, scratch("two.svg"));
  EXPECT_EQ(polylines(scratch("one.svg")), 1);
  EXPECT_EQ(polylines(scratch("two.svg")), 2);
}

TEST(Chart, ShowsEightSeriesWithEightColoursAndALegendBesideTheData) {
  draw_chart(oscillating_forces(8), forces(), scratch("legend.svg"));
  const std::string svg = file_bytes(scratch("legend.svg"));
  for (const char* colour : {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00"})
    EXPECT_TRUE(holds(svg, {colour})) << colour;
  ChartOptions bare = forces();
  bare.legend = false;
  draw_chart(oscillating_forces(8), bare, scratch("bare.svg"));
  EXPECT_FALSE(holds(file_bytes(scratch("bare.svg")), {">N2-N2.3<"}));
}

TEST(Chart, TakesConstantDataAndSinglePoints) {
  draw_chart({line_of({2, 2, 2})}, {}, scratch("flat.svg"));
  Series point = line_of({0});
  point.markers = true;
  draw_chart({point}, {}, scratch("point.svg"));
  ChartOptions log = convergence();
  draw_chart({Series{"", {10}, {1e-3}, true, true}}, log, scratch("log_point.svg"));
  EXPECT_TRUE(std::filesystem::exists(scratch("log_point.svg")));
}

TEST(Chart, RefusesWhatItCannotDraw) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(holds(refusal({}), {"at least one series"}));
  Series uneven = line_of({1, 2});
  uneven.x.pop_back();
  uneven.label = "Px";
  EXPECT_TRUE(holds(refusal({uneven}), {"series 1 'Px'", "1 x values", "2 y values"}));
  EXPECT_TRUE(holds(refusal({line_of({nan, nan})}), {"no finite point"}));
  EXPECT_TRUE(holds(refusal({line_of({1, 2})}, convergence()), {"x = 0", "logarithmic"}));
  EXPECT_TRUE(holds(refusal({line_of({1, 2})}, {}, "no.gif"), {"no.gif", ".png, .svg or .pdf"}));
  ChartOptions turned;
  turned.yrange = {2, 1};
  EXPECT_TRUE(holds(refusal({line_of({1, 2})}, turned), {"range of y is 2 to 1", "lower one first"}));
  ChartOptions tiny;
  tiny.size = {40, 30};
  EXPECT_TRUE(holds(refusal({line_of({1, 2})}, tiny), {"40 × 30", "1600, 1000"}));
  EXPECT_TRUE(holds(refusal({line_of({1, 2})}, {}, "missing/no.png"), {"does not exist"}));
}

} // namespace
} // namespace signorini::view
