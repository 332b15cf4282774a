#include "terminal/encode.hpp"

#include "messages.hpp"

#include <gtest/gtest.h>

namespace signorini::terminal {
namespace encode_test {

TEST(Encode, KittysSequencesHaveAtMost4096Characters) {
  EXPECT_EQ(kitty_sequences("foo", 0, false), "\033_Ga=T,f=100,q=2,m=0;Zm9v\033\\");
  EXPECT_EQ(kitty_sequences("foo", 7, false), "\033_Ga=T,f=100,q=2,c=7,m=0;Zm9v\033\\");
  const std::string two = kitty_sequences(std::string(3073, 'x'), 0, false);
  EXPECT_EQ(two.find("\033_Ga=T,f=100,q=2,m=1;"), 0U);
  EXPECT_TRUE(test::holds(two, {"\033\\\033_Gm=0;eA==\033\\"}));
  const std::string one = kitty_sequences(std::string(3072, 'x'), 0, false);
  EXPECT_EQ(one.size(), std::string("\033_Ga=T,f=100,q=2,m=0;\033\\").size() + 4096);
}

TEST(Encode, Iterm) {
  EXPECT_EQ(iterm_sequence("foo", 300), "\033]1337;File=inline=1;size=3;width=300px:Zm9v\a");
}

TEST(Encode, TmuxGetsDoubledEscapes) {
  EXPECT_EQ(passed_through("\033[c"), "\033Ptmux;\033\033[c\033\\");
  EXPECT_EQ(kitty_sequences("f", 0, true), "\033Ptmux;\033\033_Ga=T,f=100,q=2,C=1,m=0;Zg==\033\033\\\033\\");
}

} // namespace encode_test
} // namespace signorini::terminal
