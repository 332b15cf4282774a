// Spots of charts and heat maps: the values of data points and cells, at the places where the figure shows them.

#include "view/chart.hpp"
#include "view/heatmap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace signorini::view {
namespace spot_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
using Values = std::vector<std::array<std::string, 2>>;

/// Whether a filled polygon of the figure has its center at the point, as a marker has.
bool has_marker(const Figure& figure, const Vec2& at) {
  const auto& marks = figure.plates.front().plate.drawing.marks;
  return std::any_of(marks.begin(), marks.end(), [&](const Mark& mark) {
    const auto* fill = std::get_if<Fill>(&mark);
    if (!fill || fill->outline.size() != 20) return false;
    Vec2 center = {0, 0};
    for (const Vec2& corner : fill->outline) center = center + 1.0 / 20 * corner;
    return distance(center, at) < 1e-9;
  });
}

/// The text of the figure with this content.
const Text* find_text(const Figure& figure, const std::string& content) {
  for (const Mark& mark : figure.plates.front().plate.drawing.marks)
    if (const auto* text = std::get_if<Text>(&mark); text && text->string == content) return text;
  return nullptr;
}

TEST(Spot, LiesAtTheMarkerOfItsPoint) {
  Series curve{"N2", {1, 2, 8}, {10, nan, 0.1}};
  curve.markers = true;
  ChartOptions options;
  options.xlabel = "mesh", options.ylabel = "error (%)", options.legend_title = "order";
  options.log_x = options.log_y = true;
  for (const std::array<int, 2> size : {std::array{1600, 1000}, std::array{600, 375}}) {
    options.size = size;
    const auto spots = chart_spots({curve}, options);
    ASSERT_EQ(spots.size(), 2u); // the gap has none
    const Figure figure = chart_figure({curve}, options);
    for (const Spot& spot : spots) {
      EXPECT_EQ(spot.box[0], spot.box[1]);
      EXPECT_TRUE(has_marker(figure, {spot.box[0], spot.box[2]}));
    }
    EXPECT_FALSE(has_marker(figure, {spots[0].box[0] + 1, spots[0].box[2]})); // the test can fail
    EXPECT_EQ(spots[1].values, (Values{{"order", "N2"}, {"mesh", "8"}, {"error (%)", "0.1"}}));
  }
}

TEST(Spot, HasTheNameOfTheTickAndTheKindOfThePoint) {
  Series curve{"", {1, 2}, {3, 4}};
  curve.marks = {1, 0};
  ChartOptions options;
  options.xticks = {{1, "N2"}, {2, "N4"}};
  options.marks = {"coarse", "fine"}, options.marks_title = "mesh";
  const auto spots = chart_spots({curve}, options);
  ASSERT_EQ(spots.size(), 2u);
  EXPECT_EQ(spots[0].values, (Values{{"", "N2"}, {"", "3"}, {"mesh", "fine"}}));
}

TEST(Spot, IsOmittedOutsideTheAxesAndBelowTheInset) {
  Series curve{"", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, {0, 0, 0, 0, 0, 0, 0, 0, 9, 9}};
  ChartOptions options;
  options.xrange = {0, 5};
  EXPECT_EQ(chart_spots({curve}, options).size(), 6u);
  Series cloud{"", {}, {}, false, true};
  for (int i = 0; i < 400; ++i) cloud.x.push_back(i % 20), cloud.y.push_back(i / 20);
  options = {};
  EXPECT_EQ(chart_spots({cloud}, options).size(), 400u);
  options.inset = Inset{{2, 4}, {{2, 4}}, Corner::north_east};
  options.yrange = {-1, 20};
  const auto left = chart_spots({cloud}, options).size();
  EXPECT_LT(left, 400u);
  EXPECT_GT(left, 200u);
}

TEST(Spot, IsTheCellOfAHeatMap) {
  HeatmapOptions options;
  options.x = {"N2", "N4"}, options.y = {"10", "20"};
  options.xlabel = "order", options.ylabel = "steps", options.label = "error";
  Heat map{"", MatrixX(2, 2), {{"a", "b"}, {"", "d"}}};
  map.values << 1, 2, nan, 4;
  const auto spots = heatmap_spots({map}, options);
  ASSERT_EQ(spots.size(), 3u);
  EXPECT_EQ(spots[2].values, (Values{{"order", "N4"}, {"steps", "20"}, {"error", "4"}}));
  const Figure figure = heatmap_figure({map}, options);
  const char* texts[] = {"a", "b", "d"};
  for (std::size_t i = 0; i < 3; ++i) {
    const Text* text = find_text(figure, texts[i]);
    ASSERT_TRUE(text);
    EXPECT_TRUE(holds(spots[i].box, text->at)) << texts[i];
    EXPECT_FALSE(holds(spots[(i + 1) % 3].box, text->at)) << texts[i];
  }
}

TEST(Spot, HasTheNameOfACategoryAndTheTextOfTheCell) {
  HeatmapOptions options;
  options.x = {"N2"}, options.y = {"10"};
  options.categories = {{"completed", {}}, {"inverted", {}}};
  const auto spots = heatmap_spots({Heat{"plain", MatrixX::Constant(1, 1, 1), {{"12"}}}}, options);
  ASSERT_EQ(spots.size(), 1u);
  EXPECT_EQ(spots[0].values, (Values{{"", "plain"}, {"", "N2"}, {"", "10"}, {"", "inverted"}, {"", "12"}}));
}

} // namespace spot_test
} // namespace signorini::view
