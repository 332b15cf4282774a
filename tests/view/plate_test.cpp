// Pictures before they are files: no text is cut off, those of a series are alike, several go into one.

#include "messages.hpp"
#include "scenes.hpp"
#include "view/close_up.hpp"
#include "view/series.hpp"
#include "view/side_by_side.hpp"
#include "view/text.hpp"

#include <gtest/gtest.h>

namespace signorini::view {
namespace {

std::vector<Panel> ring(double lift, double scale = 1, const std::string& title = "") {
  Body body = bent_ring({0, lift}, 0.5, 1, 0, 6, 3);
  body.values *= scale;
  return {{title, {body}}};
}

/// The texts of a drawing that reach beyond its rim.
std::vector<std::string> cut_off(const Drawing& drawing) {
  std::vector<std::string> found;
  for (const Mark& mark : drawing.marks) {
    const Text* text = std::get_if<Text>(&mark);
    if (!text) continue;
    const double length = text_width(text->string, text->size);
    const double before = text->align == Align::left ? 0 : text->align == Align::right ? length : 0.5 * length;
    const int along = text->upright ? 1 : 0, across = 1 - along;
    const double from = text->at[along] - before, low = text->at[across] - (text->upright ? 0.75 : 0.2) * text->size,
                 high = text->at[across] + (text->upright ? 0.2 : 0.75) * text->size;
    if (from < 0 || from + length > drawing.size[along] || low < 0 || high > drawing.size[across])
      found.push_back(text->string);
  }
  return found;
}

TEST(Plate, CutsNoTextOff) {
  const std::string words = "A title that goes on and on with ΔP_x, E = 1.5·10⁹ and much else that nobody needs";
  int texts = 0;
  for (const std::array<int, 2>& size : {std::array{1600, 1000}, {400, 300}, {300, 700}, {1200, 250}})
    for (const double scale : {1e-12, 1.0, -123456.789, 1e15})
      for (const bool trim : {false, true}) {
        PictureOptions options;
        options.size = size;
        options.trim = trim;
        options.title = options.field_label = words;
        const Plate plate = make_plate(ring(scale > 1e3 ? 1e7 : 0, scale, words), options);
        EXPECT_EQ(cut_off(plate.drawing), std::vector<std::string>()) << size[0] << " × " << size[1] << ", " << scale;
        for (const Mark& mark : plate.drawing.marks) texts += std::holds_alternative<Text>(mark);
      }
  EXPECT_GT(texts, 200);
}

TEST(Plate, OfASeriesHasTheSameFrameAndColours) {
  std::vector<Panel> both = ring(0);
  both.push_back(ring(2, 3)[0]);
  PictureOptions options;
  align(options, both);
  const Frame low = make_plate({both[0]}, options).frames[0], high = make_plate({both[1]}, options).frames[0];
  EXPECT_EQ(low.box, high.box);
  EXPECT_EQ(low.y.low, high.y.low);
  EXPECT_GT(high.y.high, 3);
  EXPECT_EQ((*options.range)[1], both[1].bodies[0].values.maxCoeff());
  EXPECT_EQ((*options.range)[0], std::min(both[0].bodies[0].values.minCoeff(), both[1].bodies[0].values.minCoeff()));
}

TEST(SideBySide, PutsPicturesIntoColumns) {
  PictureOptions options;
  options.trim = true;
  options.size = {1200, 900};
  const auto make = [](int i, const std::array<int, 2>& most) {
    PictureOptions own;
    own.trim = true;
    own.size = most;
    return make_plate(ring(i), own);
  };
  const auto shape = [&](int columns) {
    options.columns = columns;
    const auto [width, height] = png_size(side_by_side(4, options, make));
    return static_cast<double>(width) / height;
  };
  EXPECT_GT(shape(4), 3 * shape(1));
  options.columns.reset();
  const auto [width, height] = png_size(side_by_side(4, options, make));
  EXPECT_LE(width, 1200);
  EXPECT_LE(height, 900);
  options.size = {200, 150};
  EXPECT_TRUE(holds(message_of([&] { side_by_side(4, options, make); }), {"4 pictures find no room"}));
}

TEST(CloseUp, MakesRoomWhereNoCornerIsFree) {
  // A plain rectangle fills its frame.
  Body block;
  block.points.resize(3, 4);
  block.points << 0, 2, 2, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  block.triangles.resize(3, 2);
  block.triangles << 0, 0, 1, 2, 2, 3;
  int drawn = 0;
  std::optional<Box> given;
  const auto whole = [&](const std::optional<Box>& extent) {
    ++drawn;
    given = extent;
    PictureOptions options;
    options.extent = extent;
    return make_plate({{"", {block}}}, options);
  };
  const auto detail = [&](const std::array<int, 2>& most) {
    PictureOptions options;
    options.size = most;
    options.trim = true;
    options.crop = {0.4, 1.6, 0.2, 0.8};
    return make_plate({{"", {block}}}, options);
  };
  with_close_up(whole, detail, false);
  EXPECT_EQ(drawn, 2);
  ASSERT_TRUE(given);
  EXPECT_GT((*given)[3], 1.5);
}

TEST(Plate, HasNoGroundWhereThatIsWanted) {
  PictureOptions options;
  options.size = {300, 200};
  const auto colour_type = [&](bool transparent) { return png(make_plate(ring(0), options), transparent)[25]; };
  EXPECT_EQ(colour_type(false), 2); // red, green, blue
  EXPECT_EQ(colour_type(true), 6);  // and opacity
}

TEST(Series, IsTakenFromTheNameOfItsFile) {
  EXPECT_TRUE(is_series("a-%04d.png"));
  EXPECT_TRUE(is_series("a.mp4"));
  EXPECT_FALSE(is_series("a.png"));
  const auto number = [](int i) { return std::to_string(i); };
  const std::string folder = scratch("");
  write_series(folder + "a-%03d.png", 2, 10, number);
  EXPECT_EQ(file_bytes(folder + "a-001.png"), "0");
  EXPECT_EQ(file_bytes(folder + "a-002.png"), "1");
  for (const char* wrong : {"a%s.png", "a%d%d.png", "a%d.jpg", "%.png", "a%00d.png"})
    EXPECT_TRUE(holds(message_of([&] { write_series(wrong, 1, 10, number); }), {"must hold one number"})) << wrong;
}

} // namespace
} // namespace signorini::view
