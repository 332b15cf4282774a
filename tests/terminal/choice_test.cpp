#include "terminal/choice.hpp"

#include <gtest/gtest.h>
#include <map>

namespace signorini::terminal {
namespace choice_test {

using Variables = std::map<std::string, std::string>;

Surroundings surroundings(const Variables& variables, const Answers& answers = {}, const std::string& outer = "") {
  const auto value = [variables](const char* name) {
    const auto found = variables.find(name);
    return found == variables.end() ? std::string() : found->second;
  };
  return {value, answers, outer};
}

std::string chosen(const Variables& variables, const Answers& answers = {}, const std::string& outer = "") {
  const auto [protocol, through] = choose(surroundings(variables, answers, outer));
  return protocol_names()[static_cast<std::size_t>(protocol)] + (through ? " through tmux" : "");
}

Answers attributes(std::vector<int> numbers, bool kitty = false) {
  Answers answers;
  answers.kitty = kitty;
  answers.attributes = std::move(numbers);
  return answers;
}

const Answers silence, plain = attributes({1, 2}), sixel = attributes({63, 1, 4}), kitty = attributes({62}, true);

TEST(Choice, FollowsTheAnswersOfTheTerminal) {
  EXPECT_EQ(chosen({{"TERM", "xterm"}}, plain), "blocks");
  EXPECT_EQ(chosen({{"TERM", "xterm"}}, sixel), "sixel");
  EXPECT_EQ(chosen({{"TERM", "xterm"}}, kitty), "kitty");
  EXPECT_EQ(chosen({{"TERM", "xterm"}}, attributes({64})), "blocks");
}

TEST(Choice, FollowsTheVariablesOfTerminalsThatDoNotAnswer) {
  EXPECT_EQ(chosen({{"TERM", "xterm-kitty"}}, silence), "kitty");
  EXPECT_EQ(chosen({{"TERM", "xterm-256color"}, {"KITTY_WINDOW_ID", "1"}}, silence), "kitty");
  EXPECT_EQ(chosen({{"TERM", "xterm"}, {"TERM_PROGRAM", "iTerm.app"}}, sixel), "iterm");
  EXPECT_EQ(chosen({{"TERM", "xterm"}, {"LC_TERMINAL", "iTerm2"}}, silence), "iterm"); // over ssh
  EXPECT_EQ(chosen({{"TERM", "xterm"}, {"TERM_PROGRAM", "WezTerm"}}, silence), "iterm");
  EXPECT_EQ(chosen({{"TERM", "xterm"}}, silence), "blocks");
}

TEST(Choice, DistrustsInheritedVariables) {
  EXPECT_EQ(chosen({{"TERM", "xterm"}, {"KITTY_WINDOW_ID", "1"}}, plain), "blocks"); // an xterm started from kitty
  EXPECT_EQ(chosen({{"TERM", "screen"}, {"STY", "1.pts"}, {"LC_TERMINAL", "iTerm2"}}, plain), "blocks");
  EXPECT_EQ(chosen({{"TERM", "tmux-256color"}, {"LC_TERMINAL", "iTerm2"}}, plain), "blocks"); // ssh from tmux
}

TEST(Choice, IsNoneForDumbTerminals) {
  EXPECT_EQ(chosen({{"TERM", "dumb"}}, kitty), "none");
  EXPECT_EQ(chosen({}, kitty), "none");
}

TEST(Choice, PassesThroughTmuxWhatItsTerminalTakes) {
  const Variables tmux = {{"TERM", "tmux-256color"}, {"TMUX", "/run/tmux,1,0"}};
  EXPECT_EQ(chosen(tmux, plain, "xterm-kitty|kitty(0.26.5)|on"), "kitty through tmux");
  EXPECT_EQ(chosen(tmux, plain, "xterm-256color|kitty(0.26.5)|all"), "kitty through tmux");
  EXPECT_EQ(chosen(tmux, plain, "xterm-256color|iTerm2 3.4.8|on"), "iterm through tmux");
  EXPECT_EQ(chosen(tmux, plain, "foot|foot(1.13.1)|on"), "sixel through tmux");
  EXPECT_EQ(chosen(tmux, plain, "xterm-kitty||"), "kitty through tmux"); // tmux 3.2 without the option
  EXPECT_EQ(chosen(tmux, plain, "xterm-kitty|kitty(0.26.5)|off"), "blocks");
  EXPECT_EQ(chosen(tmux, plain, "xterm-kitty|kitty(0.26.5)|0"), "blocks"); // tmux 3.3
  EXPECT_EQ(chosen(tmux, plain, "xterm-kitty|kitty(0.26.5)|1"), "kitty through tmux");
  EXPECT_EQ(chosen(tmux, sixel, "xterm-kitty|kitty(0.26.5)|off"), "sixel");
  EXPECT_EQ(chosen(tmux, sixel, "xterm-256color|XTerm(379)|on"), "sixel");
  EXPECT_EQ(chosen(tmux, plain, "xterm-256color|XTerm(379)|on"), "blocks");
  EXPECT_EQ(chosen(tmux, plain, "tmux-256color|tmux 3.3a|on"), "blocks"); // tmux in tmux
  EXPECT_EQ(chosen(tmux, plain, ""), "blocks");
}

TEST(Choice, OfTheUserComesFirst) {
  const auto at = surroundings({{"TERM", "dumb"}}, plain);
  EXPECT_EQ(choose(at, Protocol::sixel).protocol, Protocol::sixel);
  EXPECT_FALSE(choose(at, Protocol::sixel).through_tmux);
  const auto tmux = surroundings({{"TERM", "screen"}, {"TMUX", "x"}}, plain, "xterm-256color|XTerm(379)|on");
  EXPECT_TRUE(choose(tmux, Protocol::sixel).through_tmux);
  EXPECT_FALSE(choose(tmux, Protocol::blocks).through_tmux);
}

} // namespace choice_test
} // namespace signorini::terminal
