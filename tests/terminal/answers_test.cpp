#include "terminal/answers.hpp"

#include <gtest/gtest.h>

namespace signorini::terminal {
namespace answers_test {

/// What remains of an input, and its answers.
std::pair<std::string, Answers> taken(std::string input) {
  Answers answers;
  take_answers(input, answers);
  return {input, answers};
}

TEST(Answers, AreTakenFromBetweenTheKeys) {
  const auto [keys, answers] =
      taken("a\033_Gi=31;OK\033\\b\033[6;18;9tc\033[4;360;720td\033[?2;0;500;300Se\033[?62;4cf");
  EXPECT_EQ(keys, "abcdef");
  EXPECT_TRUE(answers.kitty);
  EXPECT_EQ(answers.attributes, (std::vector{62, 4}));
  EXPECT_EQ(answers.cell, (Size{9, 18}));
  EXPECT_EQ(answers.area, (Size{720, 360}));
  EXPECT_EQ(answers.largest_sixel, (Size{500, 300}));
}

TEST(Answers, ThatAreNotCompleteRemain) {
  for (const char* part : {"\033", "\033[", "\033[?62;4", "\033_Gi=31;OK", "\033_Gi=31;OK\033"}) {
    const auto [keys, answers] = taken(part);
    EXPECT_EQ(keys, part);
    EXPECT_FALSE(answers.kitty || answers.attributes);
  }
}

TEST(Answers, AreNotKeys) {
  // Arrows, Home, function keys, Alt with a letter, a paste, Escape alone.
  for (const char* sequence :
       {"\033[A", "\033[1;5C", "\033[3~", "\033OP", "\033f", "\033[200~x = 1\r\033[201~", "\033\033[A", "\033[c"}) {
    const auto [keys, answers] = taken(sequence);
    EXPECT_EQ(keys, sequence);
    EXPECT_FALSE(answers.attributes || answers.cell || answers.area);
  }
}

TEST(Answers, ThatDenyAreDenials) {
  EXPECT_FALSE(taken("\033_Gi=31;EINVAL:no\033\\").second.kitty);
  EXPECT_FALSE(taken("\033[?2;3;0;0S").second.largest_sixel);
  EXPECT_FALSE(taken("\033[6;0;0t").second.cell);
}

} // namespace answers_test
} // namespace signorini::terminal
