#pragma once
// Colors of the prompt and of errors.

#include <string>

namespace signorini::repl {

enum class Color { red = 31, green = 32 };

/// The text for a file such as STDERR_FILENO: in color if that is a terminal with colors, unless NO_COLOR is set
/// (no-color.org) or TERM is "dumb". `for_line_editor`: marks escape sequences as invisible for readline.
std::string painted(const std::string& text, Color color, int file, bool for_line_editor = false);

} // namespace signorini::repl
