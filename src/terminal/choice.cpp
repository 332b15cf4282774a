#include "terminal/choice.hpp"

#include "base/match.hpp"

#include <algorithm>

namespace signorini::terminal {
namespace {

/// Terminals that answer no queries about kitty's protocol, but have one of the two.
Protocol by_name(const Surroundings& at) {
  const std::string term = at.variable("TERM"), program = at.variable("TERM_PROGRAM");
  if (!at.variable("KITTY_WINDOW_ID").empty() || term == "xterm-kitty" || term == "xterm-ghostty")
    return Protocol::kitty;
  if (program == "iTerm.app" || program == "WezTerm" || at.variable("LC_TERMINAL") == "iTerm2") return Protocol::iterm;
  return Protocol::none;
}

/// Around tmux: what the outer terminal takes. Only names are known of it.
Protocol of_outer(const std::string& outer) {
  if (!match(outer, "(xterm-kitty|xterm-ghostty|[^|]*\\|kitty|[^|]*\\|ghostty).*").empty()) return Protocol::kitty;
  if (!match(outer, "[^|]*\\|(iTerm2|WezTerm).*").empty()) return Protocol::iterm;
  if (!match(outer, "(foot|[^|]*\\|foot).*").empty()) return Protocol::sixel;
  return Protocol::none;
}

bool announces_sixel(const Answers& answers) {
  const auto attributes = answers.attributes.value_or(std::vector<int>());
  return std::find(attributes.begin(), attributes.end(), 4) != attributes.end();
}

/// True if sequences reach the terminal around tmux. Versions before 3.3 lack the option and let all of them pass;
/// version 3.3 writes 0 and 1 for off and on.
bool passes_through(const Surroundings& at) {
  return in_tmux(at) && !at.outer.empty() && !at.outer.ends_with("|off") && !at.outer.ends_with("|0");
}

Protocol best(const Surroundings& at) {
  const std::string term = at.variable("TERM");
  if (term.empty() || term == "dumb") return Protocol::none;
  if (passes_through(at))
    if (const Protocol outer = of_outer(at.outer); outer != Protocol::none) return outer;
  if (at.answers.kitty) return Protocol::kitty;
  // Variables inside a multiplexer are about the terminal around it, whose protocols it does not have.
  const bool multiplexer =
      in_tmux(at) || !at.variable("STY").empty() || term.starts_with("tmux") || term.starts_with("screen");
  const Protocol named = multiplexer ? Protocol::none : by_name(at);
  // A terminal that answers, but not about kitty's protocol, has inherited its variables from another one.
  if (named == Protocol::iterm || (named == Protocol::kitty && !at.answers.attributes)) return named;
  return announces_sixel(at.answers) ? Protocol::sixel : Protocol::blocks;
}

} // namespace

const std::vector<std::string>& protocol_names() {
  static const std::vector<std::string> names = {"kitty", "iterm", "sixel", "blocks", "none"};
  return names;
}

bool in_tmux(const Surroundings& at) {
  return !at.variable("TMUX").empty();
}

Choice choose(const Surroundings& at, std::optional<Protocol> wanted) {
  const Protocol protocol = wanted.value_or(best(at));
  const bool direct = protocol == Protocol::blocks || (protocol == Protocol::sixel && announces_sixel(at.answers));
  return {protocol, passes_through(at) && !direct};
}

} // namespace signorini::terminal
