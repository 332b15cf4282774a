#include "base/match.hpp"

#include <gtest/gtest.h>

namespace signorini {
namespace match_test {

using Groups = std::vector<std::string>;

TEST(Match, ReturnsTheGroupsOfAWholeText) {
  EXPECT_EQ(match("N12.3", "N([0-9]+)(\\.([0-9]))?"), (Groups{"N12.3", "12", ".3", "3"}));
  EXPECT_EQ(match("N12", "N([0-9]+)(\\.([0-9]))?"), (Groups{"N12", "12", "", ""}));
  EXPECT_EQ(match("ab", "a|ab"), (Groups{"ab"}));
}

TEST(Match, RejectsAPartialMatch) {
  for (const char* text : {"", "xN1", "N1x", "N1\n"}) EXPECT_EQ(match(text, "N[0-9]"), Groups{}) << text;
  EXPECT_EQ(match(std::string("N1\0x", 4), "N[0-9]"), Groups{});
}

} // namespace match_test
} // namespace signorini
