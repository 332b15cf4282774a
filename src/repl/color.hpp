#pragma once
// Colors of the prompt and of errors.

#include <string>

namespace signorini::repl {

enum class Color { red = 31, green = 32 };

/// The text as it is written to a file such as STDERR_FILENO: in color when that is a terminal that has some, unless
/// NO_COLOR is set (no-color.org) or TERM is "dumb". `for_line_editor` brackets what takes no room, as readline wants.
std::string painted(const std::string& text, Color color, int file, bool for_line_editor = false);

} // namespace signorini::repl
