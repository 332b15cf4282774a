#pragma once
// Which protocol a terminal takes pictures by.

#include "terminal/answers.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace signorini::terminal {

enum class Protocol { kitty, iterm, sixel, blocks, none };

/// Their names in order: kitty, iterm, sixel, blocks, none.
const std::vector<std::string>& protocol_names();

/// What a choice depends on.
struct Surroundings {
  std::function<std::string(const char*)> variable; ///< of the environment, or ""
  Answers answers;
  /// tmux only: "name type passthrough" of its terminal, "xterm-kitty kitty(0.26.5) on"; see tmux_format.
  std::string outer = "";
};

/// For tmux display-message: the outer terminal's name (TERM) and type (its answer to XTVERSION), and the option.
inline constexpr const char* tmux_format = "#{client_termname}|#{client_termtype}|#{allow-passthrough}";

bool in_tmux(const Surroundings& at);

struct Choice {
  Protocol protocol;
  bool through_tmux; ///< pictures are for the terminal around tmux
};

/// The best protocol that the terminal takes, or the one that is wanted.
Choice choose(const Surroundings& at, std::optional<Protocol> wanted = {});

} // namespace signorini::terminal
