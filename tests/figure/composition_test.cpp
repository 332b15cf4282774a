// Pictures side by side and in films: ratios of sides, common color ranges, one structure.

#include "figure/picture.hpp"
#include "scratch.hpp"

#include <gtest/gtest.h>

namespace signorini::figure {
namespace composition_test {

using Size = std::array<int, 2>;
using Range = std::array<double, 2>;

/// A chart that notes the sizes for which it is laid out.
Picture chart(Size size, std::vector<Size>& asked) {
  Picture picture = make_picture(FlatPicture{[&asked](const Size& pixels) {
                                               asked.push_back(pixels);
                                               return view::Figure{pixels, {}};
                                             },
                                             {}},
                                 "chart");
  picture.size = size;
  return picture;
}

/// A triangle with values from 0 to `most` under a label.
Picture state(double most, const std::string& label) {
  view::Body body;
  body.skin.points.resize(3, 3);
  body.skin.points << 0, 1, 0, 0, 0, 1, 0, 0, 0;
  body.skin.triangles = Vec<3>(0, 1, 2).cast<int>();
  body.skin.values = Vec<3>(0, 0.5, 1) * most;
  StatePicture content;
  content.panel.bodies = {body};
  content.options.field_label = label;
  return make_picture(std::move(content), "state");
}

Picture sheet(std::vector<Picture> parts) {
  return make_picture(SheetPicture{std::move(parts), ""}, "sheet");
}

/// The color ranges of all fields of a figure.
std::vector<Range> ranges(const view::Figure& figure) {
  std::vector<Range> found;
  for (const auto& placed : figure.plates)
    for (const auto& relief : placed.plate.reliefs)
      for (const auto& field : relief.fields) found.push_back(field.range);
  return found;
}

TEST(Composition, FitsPicturesWithTheirRatioOfSides) {
  std::vector<Size> asked;
  EXPECT_EQ(fitted(chart({1600, 1000}, asked), {320, 320}).size, (Size{320, 200}));
  EXPECT_EQ(fitted(chart({500, 1000}, asked), {320, 320}).size, (Size{160, 320}));
}

TEST(Composition, ChartsInASheetKeepTheirRatioWithinIt) {
  std::vector<Size> asked;
  Picture whole = sheet({chart({800, 400}, asked), chart({800, 400}, asked)});
  whole.size = {1200, 900};
  const view::Figure figure = figures_of({whole})(0);
  EXPECT_LE(figure.size[0], 1200);
  EXPECT_LE(figure.size[1], 900);
  ASSERT_GE(asked.size(), 2U);
  for (const Size& size : asked) EXPECT_NEAR(size[0], 2.0 * size[1], 2);
}

TEST(Composition, StatesOfOneLabelShareTheirColorRangeOthersDoNot) {
  const auto drawn = ranges(figures_of({sheet({state(1, "u"), state(3, "u"), state(7, "p")})})(0));
  ASSERT_EQ(drawn.size(), 3U);
  EXPECT_EQ(drawn[0], (Range{0, 3}));
  EXPECT_EQ(drawn[1], (Range{0, 3}));
  EXPECT_EQ(drawn[2], (Range{0, 7}));
}

TEST(Composition, PicturesOfAFilmShareTheirColorRange) {
  const auto figures = figures_of({state(1, "u"), state(4, "u")});
  for (int i : {0, 1}) EXPECT_EQ(ranges(figures(i)), (std::vector<Range>{{0, 4}}));
}

TEST(Composition, PicturesOfAFilmHaveOneStructure) {
  std::vector<Size> asked;
  const std::string message = test::message_of([&] { figures_of({state(1, "u"), chart({800, 400}, asked)}); });
  EXPECT_EQ(message, "figure.film.contents: other = chart, first = state");
  const auto two = sheet({state(1, "u"), state(1, "u")});
  EXPECT_EQ(test::message_of([&] {
              figures_of({sheet({state(1, "u")}), two});
            }),
            "figure.film.contents: other = sheet, first = sheet");
}

} // namespace composition_test
} // namespace signorini::figure
