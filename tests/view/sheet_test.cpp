#include "view/sheet.hpp"

#include "scenes.hpp"
#include "svg.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace signorini::view {
namespace sheet_test {

const Style style = style_for({1600, 1000});

double scale_of(const Scale& scale) {
  return (scale.to - scale.from) / (scale.high - scale.low);
}

bool has_numbers(const Ticks& ticks) {
  return !ticks.labels.empty() && !ticks.labels.front().empty();
}

ModelBoxes random_boxes(int count, std::mt19937& random) {
  std::uniform_real_distribution<double> place(-20, 20), size(5, 60);
  ModelBoxes boxes;
  for (int i = 0; i < count; ++i) {
    const double x = place(random), y = place(random);
    boxes.push_back({x, x + size(random), y, y + size(random)});
  }
  return boxes;
}

TEST(Sheet, ShowsAllStatesOnOneScaleWithoutOverlap) {
  std::mt19937 random(31);
  for (int trial = 0; trial < 100; ++trial) {
    const int count = 1 + trial % 9;
    const ModelBoxes boxes = random_boxes(count, random);
    PictureOptions options;
    options.trim = trial % 2 == 0;
    options.title = trial % 3 == 0 ? "states" : "";
    options.field_label = "displacement u_y";
    if (trial % 4 == 1) options.columns = 1 + trial % 3;
    std::vector<std::string> titles(count);
    if (trial % 5 == 0) titles[0] = "first";
    const Sheet sheet = lay_out_sheet(titles, boxes, options, std::array<double, 2>{0, 1}, style);
    const double width = sheet.size[0], height = sheet.size[1];
    EXPECT_TRUE(width <= 1600 && height <= 1000);
    ASSERT_EQ(sheet.frames.size(), boxes.size());
    const double scale = scale_of(sheet.frames[0].x);
    for (int i = 0; i < count; ++i) {
      const Frame& frame = sheet.frames[i];
      EXPECT_NEAR(scale_of(frame.x), scale, 1e-9 * scale);
      EXPECT_NEAR(scale_of(frame.y), scale, 1e-9 * scale);
      EXPECT_TRUE(frame.x.low <= boxes[i][0] && frame.x.high >= boxes[i][1]);
      EXPECT_TRUE(frame.y.low <= boxes[i][2] && frame.y.high >= boxes[i][3]);
      EXPECT_TRUE(frame.box[0] > 0 && frame.box[1] < sheet.bar.left && frame.box[2] > 0 && frame.box[3] < height);
      for (int j = 0; j < i; ++j) {
        const Box &a = frame.box, &b = sheet.frames[j].box;
        EXPECT_TRUE(a[0] > b[1] || b[0] > a[1] || a[2] > b[3] || b[2] > a[3]) << i << " " << j;
      }
    }
    EXPECT_TRUE(sheet.bar.left < width && sheet.bar.bottom > 0 && sheet.bar.top < height);
    EXPECT_LE(sheet.whole[3] + (options.title.empty() ? 0 : 1.7 * style.title_size), height);
  }
}

TEST(Sheet, HasNumbersAtItsEdgesOnly) {
  std::mt19937 random(32);
  PictureOptions options;
  options.columns = 2;
  const Sheet sheet = lay_out_sheet(std::vector<std::string>(5), random_boxes(5, random), options, {}, style);
  const bool left[] = {true, false, true, false, true}, below[] = {false, false, false, true, true};
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(has_numbers(sheet.frames[i].yticks), left[i]) << i;
    EXPECT_EQ(has_numbers(sheet.frames[i].xticks), below[i]) << i;
  }
}

TEST(Sheet, UsesTheNumberOfColumnsForTheLargestStates) {
  std::mt19937 random(33);
  for (int trial = 0; trial < 20; ++trial) {
    const ModelBoxes boxes = random_boxes(7, random);
    PictureOptions options;
    const std::vector<std::string> titles(7);
    const double own = scale_of(lay_out_sheet(titles, boxes, options, {}, style).frames[0].x);
    for (int columns = 1; columns <= 7; ++columns) {
      options.columns = columns;
      try {
        EXPECT_GE(own, scale_of(lay_out_sheet(titles, boxes, options, {}, style).frames[0].x) * (1 - 1e-9));
      } catch (const Error&) { // too many columns
      }
    }
  }
}

TEST(Sheet, IsTrimmedToItsContent) {
  PictureOptions options;
  options.field_label = "displacement u_y";
  const std::array<double, 2> range = {0, 1};
  const Box strip = {-6, 206, -6, 16}, tower = {-1, 11, -6, 206};
  Sheet sheet = lay_out_sheet({""}, {strip}, options, range, style);
  EXPECT_EQ(sheet.size, (std::array<int, 2>{1600, 1000}));
  options.trim = true;
  sheet = lay_out_sheet({""}, {strip}, options, range, style);
  EXPECT_EQ(sheet.size[0], 1600);
  EXPECT_LT(sheet.size[1], 420);
  EXPECT_GT(sheet.frames[0].box[1] - sheet.frames[0].box[0], 1200);
  sheet = lay_out_sheet({""}, {tower}, options, range, style);
  EXPECT_EQ(sheet.size[1], 1000);
  EXPECT_LT(sheet.size[0], 420);
  options.title = "a title that needs more space than a tower";
  EXPECT_GT(lay_out_sheet({""}, {tower}, options, range, style).size[0], 600);
}

TEST(ColorRange, WidensASingleValueOnBothSides) {
  using Two = std::array<double, 2>;
  EXPECT_EQ(color_range({0, 0}, {}, false), (Two{-1, 1}));
  EXPECT_EQ(color_range({5, 5}, {}, false), (Two{4.5, 5.5}));
  const Two rounding = color_range({-2, -2 + 1e-13}, {}, false);
  EXPECT_NEAR(rounding[0], -2.2, 1e-9);
  EXPECT_NEAR(rounding[1], -1.8, 1e-9);
  EXPECT_EQ(color_range({1, 3}, {}, true), (Two{1, 3}));
  EXPECT_EQ(color_range({-1, 3}, {}, true), (Two{-3, 3}));
  EXPECT_EQ(color_range({-1, 3}, Two{0, 1}, true), (Two{0, 1}));
}

TEST(Sheet, GivesEqualBytesAndRejectsEmptyInput) {
  const auto ring = [](double lift) { return std::vector<Body>{bent_ring({0, lift}, 0.5, 1, 0, 6, 3)}; };
  PictureOptions options;
  options.trim = true;
  const std::vector<Panel> panels = {{"low", ring(0)}, {"high", ring(0.4)}, {"higher", ring(2)}};
  EXPECT_EQ(picture_of(panels, options), picture_of(panels, options));
  const auto shape = [&](int columns) {
    options.columns = columns;
    const auto [width, height] = make_plate(panels, options).drawing.size;
    return static_cast<double>(width) / height;
  };
  EXPECT_GT(shape(3), 2 * shape(1));
  EXPECT_TRUE(holds(message_of([&] { make_plate(std::vector<Panel>{}, {}); }), {"view.sheet.empty"}));
  auto broken = panels;
  broken[1].bodies[0].skin.values[3] = INFINITY;
  EXPECT_TRUE(holds(message_of([&] { make_plate(broken, {}); }),
                    {"view.body.field: body = (view.sheet.body: state = (view.sheet.state: number = 1), number = 0)"}));
}

} // namespace sheet_test
} // namespace signorini::view
