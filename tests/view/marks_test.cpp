#include "view/marks.hpp"

#include "scenes.hpp"
#include "solid_scenes.hpp"
#include "svg.hpp"
#include "view/text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace signorini::view {
namespace marks_test {

const Style style = style_for({1600, 1000});
const Box box = {200, 1400, 100, 900};

std::vector<Mark> drawn(const std::vector<PlacedMark>& marks, const Box& within = box) {
  Drawing drawing{{1600, 1000}, {}};
  draw_marks(drawing, marks, within, style);
  return drawing.marks;
}

/// The black texts, drawn over white ones.
std::vector<Text> texts_of(const std::vector<Mark>& marks) {
  std::vector<Text> texts;
  for (const Mark& mark : marks)
    if (const auto* text = std::get_if<Text>(&mark); text && text->color == black) texts.push_back(*text);
  return texts;
}

/// The area of a line of text, slightly smaller than its box.
Box extent(const Text& text) {
  const double half = 0.5 * text_width(text.string, text.size);
  return {text.at[0] - half, text.at[0] + half, text.at[1], text.at[1] + 0.7 * text.size};
}

std::size_t strokes_of(const std::vector<Mark>& marks) {
  return static_cast<std::size_t>(
      std::count_if(marks.begin(), marks.end(), [](const Mark& m) { return std::holds_alternative<Stroke>(m); }));
}

TEST(Marks, AreRingsWithCrossesOnWhiteWithAText) {
  const auto marks = drawn({{{800, 500}, "J = −0.2"}});
  EXPECT_EQ(strokes_of(marks), 6u); // ring and cross, each with a white outline
  EXPECT_EQ(std::get<Stroke>(marks[0]).color, white);
  double left = 1e9, right = 0;
  for (const Vec2& p : std::get<Stroke>(marks[0]).points) left = std::min(left, p[0]), right = std::max(right, p[0]);
  EXPECT_NEAR(0.5 * (left + right), 800, 1e-9);
  const auto texts = texts_of(marks);
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_EQ(texts[0].string, "J = −0.2");
  EXPECT_GT(extent(texts[0])[0], right);
  EXPECT_LT(extent(texts[0])[0], right + 30);
  EXPECT_EQ(drawn({{{800, 500}, ""}}).size(), 6u);
}

TEST(Marks, KeepTextsInsideWithoutOverlap) {
  std::vector<PlacedMark> marks;
  for (int k = 0; k < 8; ++k)
    for (const Vec2& corner : {Vec2{200, 100}, Vec2{1400, 100}, Vec2{1400, 900}, Vec2{800, 500}})
      marks.push_back({{corner[0] + 3 * k, corner[1] - 2 * k}, text("place ", marks.size())});
  const auto texts = texts_of(drawn(marks));
  EXPECT_GE(texts.size(), 12u);
  for (std::size_t a = 0; a < texts.size(); ++a) {
    const Box one = extent(texts[a]);
    EXPECT_TRUE(one[0] >= box[0] && one[1] <= box[1] && one[2] >= box[2] && one[3] <= box[3]) << texts[a].string;
    for (std::size_t b = 0; b < a; ++b) EXPECT_FALSE(overlap(one, extent(texts[b]))) << a << " on " << b;
  }
}

TEST(Marks, HaveLeadersToDisplacedTexts) {
  const std::vector<PlacedMark> crowd(8, {{800, 500}, "one of many"});
  EXPECT_EQ(strokes_of(drawn({{{800, 500}, "one of many"}})), 6u);
  const auto marks = drawn(crowd);
  EXPECT_EQ(texts_of(marks).size(), 8u);
  EXPECT_GT(strokes_of(marks), 6u);
}

TEST(Marks, OmitTextsWithoutSpace) {
  std::vector<PlacedMark> marks;
  for (int k = 0; k < 200; ++k) marks.push_back({{200.0 + 6 * k, 100}, text("point ", k, " goes on and off")});
  const auto all = drawn(marks);
  const auto texts = texts_of(all);
  EXPECT_EQ(texts[0].string, "point 0 goes on and off"); // earlier ones have priority
  EXPECT_GE(texts.size(), 5u);
  EXPECT_LT(texts.size(), 50u);
  EXPECT_TRUE(texts_of(drawn({{{210, 110}, "text"}}, {200, 220, 100, 120})).empty());
}

TEST(Marks, FitTextsInNarrowPictures) {
  const Box narrow = {100, 200, 100, 900};
  const auto texts =
      texts_of(drawn({{{195, 500}, "an inverted element, J = −0.2"}, {{150, 200}, "incomprehensibility"}}, narrow));
  ASSERT_GE(texts.size(), 4u);
  for (const Text& line : texts) {
    EXPECT_GE(extent(line)[0], 100) << line.string;
    EXPECT_LE(extent(line)[1], 200) << line.string;
  }
  EXPECT_EQ(texts.back().string, "incomprehensibility");
  EXPECT_LT(texts.back().size, texts.front().size);
}

TEST(Marks, WrapLongTexts) {
  const auto texts =
      texts_of(drawn({{{500, 500}, "a text that goes on and on until it is wider than half of the picture"}}));
  ASSERT_EQ(texts.size(), 2u);
  EXPECT_NEAR(texts[0].at[0], texts[1].at[0], 1e-9);
  EXPECT_GT(texts[0].at[1], texts[1].at[1] + texts[1].size);
}

TEST(Marks, OutsideThePictureMoveToItsEdgeWithAnArrow) {
  const std::vector<PlacedMark> marks = {{{300, 500}, "in"}, {{5000, 500}, "out"}};
  EXPECT_EQ(within(marks, box, false, style).size(), 1u);
  const auto kept = within(marks, box, true, style);
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[0].at, marks[0].at);
  EXPECT_EQ(kept[0].beyond, (Vec2{0, 0}));
  EXPECT_LT(kept[1].at[0], 1400);
  EXPECT_GT(kept[1].at[0], 1340);
  EXPECT_GT(kept[1].beyond[0], 3000);
  EXPECT_EQ(kept[1].beyond[1], 0);
  EXPECT_EQ(drawn({kept[1]}).size(), drawn({{kept[1].at, "out"}}).size() + 2); // arrow and its rim
}

std::string marked(const std::vector<PointMark>& marks, const std::optional<Bounds>& crop = {}) {
  PictureOptions options;
  options.size = {400, 300};
  options.crop = crop;
  Panel panel{"", {bent_ring({0, 0}, 0.5, 1.0, 0, 6, 3)}};
  panel.marks = marks;
  return picture_of(std::vector<Panel>{panel}, options);
}

TEST(Marks, AreAtTheirPositionInPlanePictures) {
  const Bounds crop = {{0.2, 0.1, 0}, {0.8, 0.5, 0}};
  const std::string bare = marked({}, crop);
  const auto shown = [&](double x, double y) { return marked({{{x, y, 0}, ""}}, crop) != bare; };
  constexpr double a = 1e-3;
  EXPECT_TRUE(shown(0.2 + a, 0.3) && shown(0.8 - a, 0.3) && shown(0.5, 0.1 + a) && shown(0.5, 0.5 - a));
  EXPECT_FALSE(shown(0.2 - a, 0.3) || shown(0.8 + a, 0.3) || shown(0.5, 0.1 - a) || shown(0.5, 0.5 + a));
  EXPECT_NE(marked({{{9, 9, 0}, "far"}}), marked({})); // at the edge
  const std::string message = message_of([&] { marked({{{0, std::numeric_limits<double>::infinity(), 0}, "J"}}); });
  EXPECT_TRUE(holds(message, {"view.sheet.mark: state = (), mark = J"}));
}

TEST(Marks, AreProjectedAndDrawnOnTopOfSolids) {
  PictureOptions options;
  options.size = {300, 240};
  options.camera = camera("iso");
  const auto shown = [&](const Vec<3>& at) {
    Panel panel{"", {mapped_solid(block_map({0, 0, 0}, {2, 1, 1}), {2, 1, 1}, 2)}};
    panel.marks = {{at, "here"}};
    return picture_of(std::vector<Panel>{panel}, options);
  };
  const Vec<3> place(1.2, 0.5, 0.4);
  EXPECT_TRUE(shown(place) ==
              shown(place + 0.25 * options.camera->from)); // behind or in front, the same position on paper
  EXPECT_FALSE(shown(place) == shown(place + Vec<3>(0.1, 0, 0)));
  EXPECT_FALSE(shown(place) == shown(place + Vec<3>(0, 0, 0.1)));
  options.camera = camera("front");
  EXPECT_TRUE(shown(place) == shown(place + Vec<3>(0, 0.3, 0)));
  options.crop = Bounds{{0, 0, 0}, {1, 1, 1}};
  EXPECT_TRUE(shown(place) == shown(place + Vec<3>(0.3, 0, 0))); // both are outside
}

} // namespace marks_test
} // namespace signorini::view
