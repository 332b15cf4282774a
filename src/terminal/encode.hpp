#pragma once
// PNG files as escape sequences for terminals that decode them.

#include <string>

namespace signorini::terminal {

/// By kitty's protocol. columns: width in cells, 0 for that of the picture in pixels. `around_tmux`: as
/// passed_through(), with the cursor unmoved.
std::string kitty_sequences(const std::string& png, int columns, bool around_tmux);

/// By iTerm2's protocol; `width` in pixels.
std::string iterm_sequence(const std::string& png, int width);

/// The sequence as tmux passes it on to its terminal.
std::string passed_through(const std::string& sequence);

} // namespace signorini::terminal
