#include "view/text.hpp"

#include <gtest/gtest.h>

namespace signorini::view {
namespace text_test {

TEST(TextRuns, HaveSuperscriptAndSubscriptDigits) {
  const auto runs = text_runs("σ₁₁ 10⁻³⁴");
  ASSERT_EQ(runs.size(), 4u);
  EXPECT_EQ(runs[0].string, "σ");
  EXPECT_EQ(runs[1].string, "11");
  EXPECT_EQ(runs[1].level, -1);
  EXPECT_EQ(runs[2].string, " 10");
  EXPECT_EQ(runs[3].string, "−34");
  EXPECT_EQ(runs[3].level, 1);
}

/// The runs as one string: superscripts after ^, subscripts after _, in brackets.
std::string levels(const std::string& utf8) {
  std::string result;
  for (const TextRun& run : text_runs(utf8))
    result += run.level == 0 ? run.string : (run.level > 0 ? "^[" : "_[") + run.string + "]";
  return result;
}

TEST(TextRuns, FollowTheRulesOfMarkup) {
  const std::pair<const char*, const char*> cases[] = {{"mm^2, 10^-3 m^n", "mm^[2], 10^[−3] m^[n]"},
                                                       {"x_{max} and dP_{x y}", "x_[max] and dP_[x y]"},
                                                       {"e^{i φ}-1", "e^[i φ]-1"},
                                                       {"σ_yy^2 / F_max", "σ_[yy]^[2] / F_[max]"},
                                                       {"m² u₁", "m^[2] u_[1]"},
                                                       {"a_b_c", "a_b_c"},
                                                       {"out/a_b_c.png", "out/a_b_c.png"},
                                                       {"max_pressure", "max_pressure"},
                                                       {"Größe_x", "Größe_x"},
                                                       {"E\\_x 5\\^2 \\{a\\}", "E_x 5^2 {a}"},
                                                       {"C:\\dir", "C:\\dir"},
                                                       {"p_{a\\}b}", "p_[a}b]"},
                                                       {"x_{open", "x_{open"},
                                                       {"a ^2 ^ _", "a ^2 ^ _"},
                                                       {"1_2", "1_2"},
                                                       {"2∫_Γ t·δu dΓ", "2∫_[Γ] t·δu dΓ"},
                                                       {"∂_x u, ∇_s, Σ_i, ∑_i^n", "∂_[x] u, ∇_[s], Σ_[i], ∑_[i]^[n]"},
                                                       {"∫^b_a ∂u_x", "∫^[b]_[a] ∂u_[x]"}};
  for (const auto& [utf8, expected] : cases) EXPECT_EQ(levels(utf8), expected) << utf8;
}

TEST(TextRuns, LowerTheIndexOfASingleLetter) {
  const auto runs = text_runs("displacement u_y (p_max)");
  ASSERT_EQ(runs.size(), 5u);
  EXPECT_EQ(runs[1].string, "y");
  EXPECT_EQ(runs[1].level, -1);
  EXPECT_EQ(runs[2].string, " (p");
  EXPECT_EQ(runs[3].string, "max");
  EXPECT_EQ(runs[4].string, ")");
  EXPECT_EQ(text_runs("σ_xx")[1].level, -1);
  for (const char* plain : {"max_pressure", "u_", "_y", "a __b", "uy_046.png"})
    EXPECT_EQ(text_runs(plain).size(), 1u) << plain;
}

TEST(CodePoints, RoundTripAndReplaceInvalidBytes) {
  const std::string all = "Aµ−𝄞";
  std::string again;
  for (char32_t p : code_points(all)) again += to_utf8(p);
  EXPECT_EQ(again, all);
  EXPECT_EQ(code_points("a\xFFz"), (std::vector<char32_t>{U'a', 0xFFFD, U'z'}));
  EXPECT_EQ(code_points("\xE2\x88"), (std::vector<char32_t>{0xFFFD}));
}

/// Liberation Sans, which scripts/setup installs, has the widths of Helvetica (Adobe's core font metrics).
TEST(TextWidth, IsThatOfHelvetica) {
  EXPECT_NEAR(text_width("0123456789", 100), 556, 0.5);
  EXPECT_NEAR(text_width("Wi", 10), 9.44 + 2.22, 0.02);
  EXPECT_NEAR(text_width("1²", 10), 5.56 * 1.7, 0.05);
}

} // namespace text_test
} // namespace signorini::view
