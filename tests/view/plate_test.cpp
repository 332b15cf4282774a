// Pictures before rendering: no truncated texts, equal layout in series, several in one figure.

#include "os/whole_file.hpp"
#include "scenes.hpp"
#include "scratch.hpp"
#include "solid_scenes.hpp"
#include "svg.hpp"
#include "view/compose.hpp"
#include "view/series.hpp"
#include "view/text.hpp"

#include <gtest/gtest.h>

namespace signorini::view {
namespace plate_test {

std::vector<Panel> ring(double lift, double scale = 1, const std::string& title = "") {
  Body body = bent_ring({0, lift}, 0.5, 1, 0, 6, 3);
  body.skin.values *= scale;
  return {{title, {body}}};
}

/// The area of a text from `below` its baseline to `above` it, both relative to its size.
Box covered_by(const Text& text, double below, double above) {
  const double length = text_width(text.string, text.size);
  const double before = text.align == Align::left ? 0 : text.align == Align::right ? length : 0.5 * length;
  const std::size_t along = text.upright ? 1 : 0, across = 1 - along;
  const double from = text.at[along] - before, low = text.at[across] - (text.upright ? above : below) * text.size,
               high = text.at[across] + (text.upright ? below : above) * text.size;
  return text.upright ? Box{low, high, from, from + length} : Box{from, from + length, low, high};
}

/// The texts that extend beyond the edge of a drawing.
std::vector<std::string> cut_off(const Drawing& drawing) {
  std::vector<std::string> found;
  for (const Mark& mark : drawing.marks) {
    const Text* text = std::get_if<Text>(&mark);
    if (!text) continue;
    const Box box = covered_by(*text, 0.2, 0.75);
    if (box[0] < 0 || box[1] > drawing.size[0] || box[2] < 0 || box[3] > drawing.size[1]) found.push_back(text->string);
  }
  return found;
}

/// The pairs of overlapping texts of a drawing, from the baselines to the tops of their capitals.
std::vector<std::string> overlaps(const Drawing& drawing) {
  std::vector<std::string> found;
  std::vector<const Text*> texts;
  for (const Mark& mark : drawing.marks)
    if (const Text* text = std::get_if<Text>(&mark)) texts.push_back(text);
  for (std::size_t i = 0; i < texts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Box a = covered_by(*texts[i], 0, 0.72), b = covered_by(*texts[j], 0, 0.72);
      if (overlap(a, b)) found.push_back(texts[j]->string + " | " + texts[i]->string);
    }
  return found;
}

using Sizes = std::vector<std::array<int, 2>>;

const std::string words = "A title that goes on and on with ΔP_x, E = 1.5·10⁹ and much else that nobody needs";

/// Calls check(plate, description) for plates of all sizes, with tiny and huge numbers, that `make` returns for options
/// and a scale of the values; returns the number of their texts.
int each_plate(const Sizes& sizes, const std::function<Plate(const PictureOptions&, double)>& make) {
  int texts = 0;
  for (const std::array<int, 2>& size : sizes)
    for (const double scale : {1e-12, 1.0, -123456.789, 1e15})
      for (const bool trim : {false, true}) {
        PictureOptions options;
        options.size = size;
        options.trim = trim;
        options.title = options.field_label = words;
        const Plate plate = make(options, scale);
        const std::string what = text(size[0], " × ", size[1], ", ", scale, trim ? ", trimmed" : "");
        EXPECT_EQ(cut_off(plate.drawing), std::vector<std::string>()) << what;
        EXPECT_EQ(overlaps(plate.drawing), std::vector<std::string>()) << what;
        for (const Mark& mark : plate.drawing.marks) texts += std::holds_alternative<Text>(mark);
      }
  return texts;
}

TEST(Plate, ContainsAllTextsWithoutOverlap) {
  const Sizes sizes = {{1600, 1000}, {400, 300}, {300, 700}, {1200, 250}};
  const int texts = each_plate(sizes, [](const PictureOptions& options, double scale) {
    return make_plate(ring(scale > 1e3 ? 1e7 : 0, scale, words), options);
  });
  EXPECT_GT(texts, 200);
}

TEST(Plate, OfASheetContainsAllTexts) {
  const Sizes sizes = {{1600, 2000}, {560, 1120}, {900, 400}};
  const int texts = each_plate(sizes, [](const PictureOptions& options, double scale) {
    std::vector<Panel> panels = ring(0, scale, words);
    for (const double lift : {0.1, 3.0, 5.0}) panels.push_back(ring(lift, scale, "state")[0]);
    return make_plate(panels, options);
  });
  EXPECT_GT(texts, 300);
}

TEST(Plate, OfSolidsContainsAllTexts) {
  for (const char* seen : {"iso", "front"}) {
    const Sizes sizes = {{1600, 1000}, {560, 1120}, {560, 160}, {300, 200}};
    const int texts = each_plate(sizes, [&](const PictureOptions& options, double scale) {
      const Body block =
          mapped_solid(block_map({0, 0, 0}, {2, 1, 0.6}), {2, 1, 1}, 2, [&](const Vec<3>& x) { return scale * x[2]; });
      PictureOptions solid = options;
      solid.camera = camera(seen);
      return make_plate({{"start", {block}}, {words, {block}}, {"end", {block}}}, solid);
    });
    EXPECT_GT(texts, 150);
  }
}

TEST(Plate, OfASeriesHasTheSameFrameAndColors) {
  std::vector<Panel> both = ring(0);
  both.push_back(ring(2, 3)[0]);
  PictureOptions options;
  align(options, both);
  const Frame low = make_plate({both[0]}, options).frames[0], high = make_plate({both[1]}, options).frames[0];
  EXPECT_EQ(low.box, high.box);
  EXPECT_EQ(low.y.low, high.y.low);
  EXPECT_GT(high.y.high, 3);
  EXPECT_EQ((*options.range)[1], both[1].bodies[0].skin.values.maxCoeff());
  EXPECT_EQ((*options.range)[0],
            std::min(both[0].bodies[0].skin.values.minCoeff(), both[1].bodies[0].skin.values.minCoeff()));
}

TEST(SideBySide, ArrangesPicturesInColumns) {
  PictureOptions options;
  options.trim = true;
  options.size = {1200, 900};
  const auto make = [](int i, const std::array<int, 2>& most) {
    PictureOptions own;
    own.trim = true;
    own.size = most;
    return figure_of(make_plate(ring(i), own));
  };
  const auto shape = [&](int columns) {
    options.columns = columns;
    const auto [width, height] = side_by_side(4, options, make).size;
    return static_cast<double>(width) / height;
  };
  EXPECT_GT(shape(4), 3 * shape(1));
  options.columns.reset();
  const auto [width, height] = side_by_side(4, options, make).size;
  EXPECT_LE(width, 1200);
  EXPECT_LE(height, 900);
  options.size = {200, 150};
  EXPECT_TRUE(holds(message_of([&] { side_by_side(4, options, make); }),
                    {"view.pictures.space: count = 4, width = 200, height = 150, reason = (view.pictures.larger)"}));
}

TEST(SideBySide, HasOneLayoutForDifferentBars) {
  const Bar narrow{{0, 1}, "u"}, wide{{-16000, 3000}, "a long title of a color bar"};
  const auto frame_with = [](const Bar& own, const std::vector<Bar>& adjacent, bool flat) {
    PictureOptions options;
    options.trim = true;
    options.range = own.range;
    options.field_label = own.title;
    options.adjacent_bars = adjacent;
    if (flat) options.extent = Box{-40, 40, -1, 2};
    const Plate plate = make_plate(ring(0), options);
    return std::pair{plate.frames[0].box, plate.drawing.size};
  };
  for (const bool flat : {false, true}) {
    EXPECT_EQ(frame_with(narrow, {wide}, flat), frame_with(wide, {narrow}, flat));
    EXPECT_EQ(frame_with(wide, {narrow, wide}, flat), frame_with(wide, {}, flat));
    EXPECT_NE(frame_with(narrow, {}, flat), frame_with(wide, {}, flat));
  }
}

TEST(CloseUp, ExtendsTheFrameWithoutFreeCorner) {
  // A rectangle that fills its frame.
  Body block;
  block.skin = plane_surface({1, 1}, [](double u, double v) { return Vec<3>(2 * u, v, 0); });
  int drawn = 0;
  std::optional<Box> given;
  const auto whole = [&](int, const std::optional<Box>& extent) {
    ++drawn;
    given = extent;
    PictureOptions options;
    options.extent = extent;
    return make_plate({{"", {block}}}, options);
  };
  const auto detail = [&](int, int state, const std::array<int, 2>& most) {
    EXPECT_EQ(state, 0);
    PictureOptions options;
    options.size = most;
    options.trim = true;
    options.crop = Bounds{{0.4, 0.2, 0}, {1.6, 0.8, 0}};
    return make_plate({{"", {block}}}, options);
  };
  const CloseUpPlan plan = plan_close_ups(1, whole, detail);
  EXPECT_EQ(drawn, 2);
  EXPECT_EQ(with_close_ups(0, plan, whole, detail).plates.size(), 2u);
  ASSERT_TRUE(given);
  EXPECT_GT((*given)[3], 1.5);
}

TEST(CloseUp, UsesTheSameCornerInAllPictures) {
  // The first ring lies to the right of the center of its frame, the second one above it.
  const auto whole = [](int picture, const std::optional<Box>& extent) {
    PictureOptions options;
    options.extent = extent.value_or(Box{-4, 4, -4, 4});
    options.range = {0, 1};
    const Body first = bent_ring({0, 0}, 1, 3, picture == 0 ? -45 : 45, 6, 3);
    return make_plate({{"", {first}}}, options);
  };
  const auto detail = [](int, int, const std::array<int, 2>& most) {
    PictureOptions options;
    options.size = most;
    options.trim = true;
    options.crop = Bounds{{-0.1, -0.1, 0}, {0.1, 0.1, 0}};
    return make_plate(ring(0), options);
  };
  const CloseUpPlan both = plan_close_ups(2, whole, detail), one = plan_close_ups(1, whole, detail);
  EXPECT_FALSE(both.extent);
  EXPECT_FALSE(one.extent);
  EXPECT_EQ(both.corner, 3);
  EXPECT_NE(one.corner, 3);
  const auto place = [&](int picture) { return with_close_ups(picture, both, whole, detail).plates[1].at; };
  EXPECT_EQ(place(0), place(1));
}

TEST(Plate, IsTransparentOnRequest) {
  PictureOptions options;
  options.size = {300, 200};
  const auto color_type = [&](bool transparent) {
    return bytes_of(figure_of(make_plate(ring(0), options)), Format::png, transparent)[25];
  };
  EXPECT_EQ(color_type(false), 2); // RGB
  EXPECT_EQ(color_type(true), 6);  // RGBA
}

TEST(Series, IsRecognizedByItsFileName) {
  EXPECT_TRUE(is_series("a-%04d.png"));
  EXPECT_TRUE(is_series("a.mp4"));
  EXPECT_TRUE(is_film("a.mp4"));
  EXPECT_FALSE(is_film("a-%d.png"));
  EXPECT_FALSE(is_series("a.png"));
  EXPECT_FALSE(is_series("100 %d/a.png")) << "the folder is not part of the name";
  const auto number = [](int i) { return std::to_string(i); };
  const test::ScratchFolder folder;
  write_series(folder.file("a-%03d.png"), 2, 10, number);
  EXPECT_EQ(read_file(folder.file("a-001.png")), "0");
  EXPECT_EQ(read_file(folder.file("a-002.png")), "1");
  for (const char* wrong : {"a%s.png", "a%d%d.png", "%.png", "a%00d.png"})
    EXPECT_TRUE(holds(message_of([&] { write_series(wrong, 1, 10, number); }), {"view.series.number"})) << wrong;
  EXPECT_TRUE(holds(message_of([&] { write_series("a%d.jpg", 1, 10, number); }), {"view.file.ending: file = a%d.jpg"}));
}

} // namespace plate_test
} // namespace signorini::view
