// Figures as PNG, SVG and PDF: one back end with identical positions.
#include "view/figure.hpp"

#include "svg.hpp"
#include "view/text.hpp"

#include <gtest/gtest.h>

namespace signorini::view {
namespace figure_test {

Figure figure(std::vector<Mark> marks) {
  return figure_of({Drawing{{200, 150}, std::move(marks)}});
}

TEST(Figure, GivesEqualBytesEachTime) {
  const Figure one = figure({Text{{10, 20}, "σ_{11} (x)", 12}, Stroke{{{0, 0}, {9, 9}}, black, 1, {2, 3}},
                             Fill{{{50, 50}, {90, 50}, {70, 80}}, Rgb{200, 30, 30}}});
  for (Format format : {Format::png, Format::svg, Format::pdf}) {
    const std::string first = bytes_of(one, format);
    bytes_of(figure({Text{{10, 20}, "another", 20}}), format);
    EXPECT_EQ(bytes_of(one, format), first) << static_cast<int>(format);
    EXPECT_NE(bytes_of(figure({}), format), first);
  }
}

TEST(Figure, HasTheFormatOfItsFileExtension) {
  EXPECT_EQ(bytes_of(figure({}), format_of("a.PNG")).substr(1, 3), "PNG");
  EXPECT_EQ(bytes_of(figure({}), format_of("a.b.pdf")).substr(0, 5), "%PDF-");
  EXPECT_TRUE(holds(bytes_of(figure({}), format_of("a.svg")), {"width=\"200px\" height=\"150px\""}));
  EXPECT_EQ(message_of([] { format_of("a.jpg"); }), "view.file.ending: file = a.jpg");
}

/// By the position of the first letter's outline in an SVG.
TEST(Figure, PlacesTextsAsLayoutsExpect) {
  const std::string text = "N2-N2.2";
  const double width = text_width(text, 20);
  const auto place = [&](Align align) {
    const std::string out = bytes_of(figure({Text{{100, 30}, text, 20, align}}), Format::svg);
    const std::string key = "<use xlink:href=\"#glyph0-1\" x=\"";
    const std::size_t at = out.find(key);
    EXPECT_NE(at, std::string::npos) << out;
    const std::size_t y = out.find(" y=\"", at) + 4;
    return Vec2{std::stod(out.substr(at + key.size())), std::stod(out.substr(y))};
  };
  EXPECT_NEAR(place(Align::left)[0], 100, 0.01);
  EXPECT_NEAR(place(Align::center)[0], 100 - width / 2, 0.01);
  EXPECT_NEAR(place(Align::right)[0], 100 - width, 0.01);
  EXPECT_NEAR(place(Align::left)[1], 120, 0.01); // y points downwards
}

TEST(Figure, HasTextWidthsInProportionToFontSize) {
  EXPECT_NEAR(text_width("Contact pressure", 30), 3 * text_width("Contact pressure", 10), 1e-9);
  EXPECT_EQ(text_width("", 30), 0);
  // Superscripts and subscripts are smaller.
  EXPECT_NEAR(text_width("10^{25}", 10) - text_width("10", 10), 0.7 * text_width("25", 10), 0.1);
  EXPECT_LT(text_width("iii", 10), text_width("mmm", 10));
}

TEST(Figure, EmbedsFontsInPdf) {
  const std::string out = bytes_of(figure({Text{{10, 20}, "force, αβγ", 12}}), Format::pdf);
  EXPECT_TRUE(holds(out, {"/FontFile2"}));
}

TEST(Figure, ContainsSearchableTextsInSvg) {
  const Drawing drawing{{200, 150}, {Text{{10, 20}, "a < b & σ₁₁ [N/mm²]", 12}}};
  const std::string out = bytes_of(figure_of({drawing}), Format::svg);
  EXPECT_TRUE(holds(out, {"a &lt; b &amp; σ<tspan", ">11</tspan>", "<text x=\"10\" y=\"130\"", "fill-opacity=\"0\""}))
      << out;
  const Figure shifted{{400, 300}, {{{100, 50}, {drawing}}}};
  EXPECT_TRUE(holds(bytes_of(shifted, Format::svg), {"<text x=\"110\" y=\"230\""}));
}

TEST(Figure, WarnsOfCharactersWithoutFont) {
  testing::internal::CaptureStderr();
  bytes_of(figure({Text{{10, 20}, "x \U000F0000", 12}}), Format::pdf); // private use area
  bytes_of(figure({Text{{10, 20}, "x \xff", 12}}), Format::png);
  EXPECT_TRUE(holds(testing::internal::GetCapturedStderr(),
                    {"view.text.no_font: characters = (\U000F0000), text = ", "view.text.encoding: text = x "}));
}

TEST(Figure, DrawsLaterPlatesOverEarlierOnes) {
  const Plate below{Drawing{{60, 40}, {Fill{{{0, 0}, {60, 0}, {60, 40}, {0, 40}}, black}}}};
  const Plate above{Drawing{{60, 40}, {}}};
  const Figure covered{{60, 40}, {{{0, 0}, below}, {{0, 0}, above}}}, blank{{60, 40}, {{{0, 0}, above}}};
  for (bool transparent : {false, true})
    EXPECT_EQ(bytes_of(covered, Format::png, transparent), bytes_of(blank, Format::png, transparent));
  EXPECT_NE(bytes_of(blank, Format::png, true), bytes_of(blank, Format::png, false));
}

} // namespace figure_test
} // namespace signorini::view
