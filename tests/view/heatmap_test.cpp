#include "view/heatmap.hpp"

#include "scenes.hpp"
#include "svg.hpp"
#include "view/text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace signorini::view {
namespace heatmap_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

HeatmapOptions three_by_two() {
  HeatmapOptions options;
  options.x = {"N2", "N3", "N4"};
  options.y = {"10", "20"};
  options.xlabel = "label";
  options.ylabel = "steps";
  return options;
}

Heat ramp() {
  Heat map;
  map.values.resize(2, 3);
  map.values << 1, 10, 100, 1000, nan, 10;
  return map;
}

std::string svg_of(const std::vector<Heat>& maps, const HeatmapOptions& options) {
  return bytes_of(heatmap_figure(maps, options), Format::svg);
}

std::string refusal(const std::vector<Heat>& maps, const HeatmapOptions& options) {
  return message_of([&] { heatmap_figure(maps, options); });
}

TEST(Heatmap, GivesEqualBytesForEqualCallsInEachFormat) {
  for (const Format format : {Format::png, Format::svg, Format::pdf})
    EXPECT_EQ(bytes_of(heatmap_figure({ramp()}, three_by_two()), format),
              bytes_of(heatmap_figure({ramp()}, three_by_two()), format));
  EXPECT_EQ(heatmap_figure({ramp()}, three_by_two()).size, (std::array<int, 2>{1600, 1000}));
}

TEST(Heatmap, ColorsCellsByValueOrByItsLogarithm) {
  HeatmapOptions options = three_by_two();
  options.colormap = "gray"; // 0x20 … 0xf0
  const std::string filled = "stroke:none;fill-rule";
  const std::string linear = svg_of({ramp()}, options);
  EXPECT_TRUE(
      holds(linear, {in_svg("#202020"), in_svg("#f0f0f0"), in_svg("#222222")})); // 10 in 1 … 1000 is level 2 of 255
  options.log = true;
  options.range = {1, 1000};
  const std::string log = svg_of({ramp()}, options);
  EXPECT_TRUE(holds(log, {in_svg("#656565"), in_svg("#ababab")})); // at one third and two thirds
  EXPECT_TRUE(holds(log, {">10<", "10<tspan"}));
  options.range = {10, 100};
  const std::string cut = svg_of({ramp()}, options);
  EXPECT_EQ(count_of(cut, filled), count_of(log, filled) + 2); // both ends of the bar are pointed
}

TEST(Heatmap, PutsTheFirstRowAtTheBottomAndNamesAtCellCenters) {
  const std::string svg = svg_of({ramp()}, three_by_two());
  EXPECT_GT(number_at(svg, ">10</text>", "y"), number_at(svg, ">20</text>", "y") + 200);
  const double n2 = number_at(svg, ">N2</text>", "x"), n3 = number_at(svg, ">N3</text>", "x"),
               n4 = number_at(svg, ">N4</text>", "x");
  EXPECT_NEAR(n3 - n2, n4 - n3, 0.02);
  EXPECT_GT(n3 - n2, 300);
}

TEST(Heatmap, WritesFittingTextsInBlackOrWhite) {
  Heat map = ramp();
  map.texts = {{"one", "a text that is far too long" + std::string(80, 'w'), ""}, {"high", "", "x"}};
  HeatmapOptions options = three_by_two();
  options.colormap = "gray";
  const std::string svg = svg_of({map}, options);
  EXPECT_TRUE(holds(svg, {">one<", ">high<"}));
  EXPECT_FALSE(holds(svg, {"far too long"}));
  const auto color = [&](const std::string& text) {
    return svg.substr(svg.rfind("fill=\"", svg.find(">" + text + "<")) + 6, 7);
  };
  EXPECT_EQ(color("one"), "#ffffff");
  EXPECT_EQ(color("high"), "#000000");
  Heat flat; // its cells are too low for legible letters
  flat.values.setConstant(80, 3, 1.0);
  flat.texts.assign(80, {"one", "", ""});
  options.y.assign(80, "");
  EXPECT_FALSE(holds(svg_of({flat}, options), {">one<"}));
}

TEST(Heatmap, ListsOccurringCategoriesInOrder) {
  HeatmapOptions options = three_by_two();
  options.categories = {{"converged", good_looks()[0]}, {"never", bad_looks()[0]}, {"failed", bad_looks()[8]}};
  Heat map = ramp();
  map.values << 2, 0, 0, nan, 0, 2;
  const std::string svg = svg_of({map}, options);
  EXPECT_TRUE(holds(svg, {">converged<", ">failed<"}));
  EXPECT_FALSE(holds(svg, {">never<"}));
  EXPECT_LT(number_at(svg, ">converged<", "y"), number_at(svg, ">failed<", "y"));
  EXPECT_EQ(count_of(svg, ";fill:" + in_svg("#cdebe4")), 3 + 1); // cells, and the swatch of the legend
}

TEST(Heatmap, SharesNamesAndBarAmongMaps) {
  Heat left = ramp(), right = ramp();
  left.title = "before", right.title = "after";
  HeatmapOptions options = three_by_two();
  const std::string adjacent = svg_of({left, right}, options);
  EXPECT_EQ(count_of(adjacent, ">N3<"), 2);
  EXPECT_EQ(count_of(adjacent, ">20<"), 1);
  EXPECT_NEAR(number_at(adjacent, ">before<", "y"), number_at(adjacent, ">after<", "y"), 0.01);
  options.columns = 1;
  const std::string stacked = svg_of({left, right}, options);
  EXPECT_EQ(count_of(stacked, ">N3<"), 1);
  EXPECT_EQ(count_of(stacked, ">20<"), 2);
  EXPECT_LT(number_at(stacked, ">before<", "y") + 300, number_at(stacked, ">after<", "y"));
}

TEST(Heatmap, RejectsInvalidInput) {
  HeatmapOptions options = three_by_two();
  Heat map = ramp();
  map.values.setConstant(nan);
  EXPECT_TRUE(holds(refusal({map}, options), {"view.heatmap.blank"}));
  options.log = true;
  map = ramp();
  map.values(0, 1) = 0;
  EXPECT_TRUE(holds(refusal({map}, options), {"view.heatmap.log: map = (), row = 0, column = 1, value = 0"}));
  EXPECT_TRUE(
      holds(refusal({ramp(), map}, options), {"view.heatmap.log: map = (view.heatmap.map: number = 1), row = 0"}));
  options.range = {-1, 10};
  EXPECT_TRUE(holds(refusal({ramp()}, options), {"view.heatmap.range: low = -1"}));
}

TEST(Heatmap, LeavesCellsWithNonFiniteValuesBlank) {
  Heat map = ramp();
  map.values << 1, 10, 100, 1000, nan, nan;
  const std::string expected = svg_of({map}, three_by_two());
  map.values(1, 1) = std::numeric_limits<double>::infinity();
  map.values(1, 2) = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(svg_of({map}, three_by_two()), expected);
}

TEST(Heatmap, KeepsTheSizeOfNamesNextToALongOne) {
  HeatmapOptions options = three_by_two();
  const std::string words = "a name of very many words that do not find space in a third of the map's whole width";
  options.y[1] = words + ", and then some more of them, until three lines are full as well and something is " + words;
  options.x[0] = "a name on lines";
  const std::string svg = svg_of({ramp()}, options);
  EXPECT_NEAR(number_at(svg, ">10</text>", "font-size"), 27, 1e-9);
  EXPECT_GE(number_at(svg, ">a name of very", "font-size"), 18);
  EXPECT_TRUE(holds(svg, {"…"}));
  EXPECT_LT(number_at(svg, ">N3</text>", "x"), number_at(svg, ">N4</text>", "x"));
  options.categories = {{"converged", good_looks()[0]}, {words, bad_looks()[0]}};
  Heat map = ramp();
  map.values << 0, 1, 0, nan, 0, 1;
  const std::string outcomes = svg_of({map}, options);
  EXPECT_NEAR(number_at(outcomes, ">converged<", "font-size"), 27, 1e-9);
}

// ── Names ────────────────────────────────────────────────────────────────────────────────────────────────────────────

const Style usual = style_for({1600, 1000});

std::vector<Name> numbers(int count) {
  std::vector<Name> names;
  for (int i = 0; i < count; ++i) names.push_back({i + 0.5, text("0.", 100 + i)});
  return names;
}

TEST(CellNames, TurnUprightOrAreThinnedOutInsteadOfOverlapping) {
  const std::vector<Name> words = {{0.5, "N2-N2.2 fine"}, {1.5, "N2-N4 fine"}, {2.5, "L1 coarse"}};
  const auto below = [&](double width, double most) {
    return named_ticks(words, {0, 3, false, 0, 3 * width}, most, usual);
  };
  const Ticks roomy = below(400, 300);
  EXPECT_FALSE(roomy.upright);
  EXPECT_EQ(roomy.names[0].size, usual.tick_size);
  const Ticks dense = below(60, 300);
  EXPECT_TRUE(dense.upright);
  EXPECT_EQ(dense.names.size(), 3u);
  EXPECT_NEAR(dense.depth, dense.names[0].width() - usual.tick_size, 1e-9);
  EXPECT_EQ(below(10, 300).names.size(), 1u); // lines of 18 × 1.2 pixels
  EXPECT_LE(below(60, 100).depth, 100.0 + 1e-9);
}

TEST(CellNames, NeverOverlap) {
  for (double width : {12.0, 25.0, 40.0, 70.0, 200.0}) {
    const Scale scale = {0, 30, false, 0, 30 * width};
    const Ticks names = named_ticks(numbers(30), scale, 300, usual),
                adjacent = stacked_names(numbers(30), scale, 300, usual);
    EXPECT_FALSE(names.upright);
    EXPECT_EQ(names.at[0], 0.5);
    for (std::size_t i = 1; i < names.at.size(); ++i) {
      EXPECT_GT(scale(names.at[i]) - scale(names.at[i - 1]), names.names[i].width()) << width;
      EXPECT_NEAR(names.at[i] - names.at[i - 1], names.at[1] - names.at[0], 1e-12);
    }
    for (std::size_t i = 1; i < adjacent.at.size(); ++i)
      EXPECT_GT(scale(adjacent.at[i]) - scale(adjacent.at[i - 1]), adjacent.names[i].size) << width;
  }
}

// ── Looks ────────────────────────────────────────────────────────────────────────────────────────────────────────────

TEST(Looks, DifferInLightnessOrHatching) {
  ASSERT_GE(bad_looks().size(), 14u);
  std::vector<Look> all = good_looks();
  all.insert(all.end(), bad_looks().begin(), bad_looks().end());
  for (std::size_t a = 0; a < all.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const double apart = std::abs(lightness(all[a].color) - lightness(all[b].color));
      EXPECT_TRUE(all[a].hatch != all[b].hatch || apart > 7) << a << " and " << b << ": " << apart;
    }
  for (const Look& good : good_looks())
    for (const Look& bad : bad_looks()) EXPECT_GT(lightness(good.color), lightness(bad.color) + 7);
}

TEST(Looks, HaveTextInTheColorOfGreaterContrast) {
  EXPECT_EQ(text_color({255, 255, 0}), black);
  EXPECT_EQ(text_color({0, 0, 255}), white);
  EXPECT_NEAR(lightness(white), 100, 1e-6);
  EXPECT_NEAR(lightness({119, 119, 119}), 50.0, 0.1);
}

} // namespace heatmap_test
} // namespace signorini::view
