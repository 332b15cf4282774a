#include "view/text.hpp"

#include <gtest/gtest.h>

namespace signorini::view {
namespace fit_text_test {

using Lines = std::vector<std::string>;

TEST(FitText, ShrinksSlightlyBeforeWrapping) {
  const std::string words = "four words of text";
  const double width = text_width(words, 20);
  EXPECT_EQ(fit_text(words, 20, 10, width + 1, 3).lines, Lines{words});
  EXPECT_EQ(fit_text(words, 20, 10, width + 1, 3).size, 20);
  const FittedText smaller = fit_text(words, 20, 10, 0.9 * width, 3);
  EXPECT_EQ(smaller.lines, Lines{words});
  EXPECT_NEAR(smaller.size, 18, 0.6);
  const FittedText wrapped = fit_text(words, 20, 10, 0.7 * width, 3);
  EXPECT_EQ(wrapped.lines, (Lines{"four words", "of text"}));
  EXPECT_EQ(wrapped.size, 20);
  EXPECT_NEAR(wrapped.depth(), 24, 1e-12);
  EXPECT_FALSE(wrapped.cut);
}

TEST(FitText, StaysWithinItsWidthAndTruncatesTheRest) {
  const std::string words = "a title that goes on and on with F_{normal contact} and 10^{-12} and many more words";
  for (const double space : {40.0, 90.0, 200.0, 400.0, 900.0})
    for (const int most : {1, 2, 3}) {
      const FittedText fitted = fit_text(words, 30, 18, space, most);
      EXPECT_LE(fitted.width(), space + 1e-9);
      EXPECT_LE(static_cast<int>(fitted.lines.size()), most);
      EXPECT_GE(fitted.size, 18);
      EXPECT_EQ(fitted.cut, fitted.lines.back().ends_with("…")) << space;
    }
  EXPECT_TRUE(fit_text(words, 30, 18, 200, 3).cut);
  EXPECT_FALSE(fit_text(words, 30, 18, 900, 1).cut);
  EXPECT_EQ(fit_text("F_{normal contact}", 20, 20, text_width("F_{norm}…", 20) + 1).lines, Lines{"F_{norm}…"});
  EXPECT_EQ(fit_text("", 20, 10, 100).lines, Lines{""});
}

} // namespace fit_text_test
} // namespace signorini::view
