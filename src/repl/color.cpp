#include "repl/color.hpp"

#include <cstdlib>
#include <string_view>
#include <unistd.h>

namespace signorini::repl {

namespace {

bool has_colors(int file) {
  const char *no_color = std::getenv("NO_COLOR"), *terminal = std::getenv("TERM");
  return isatty(file) && !(no_color && *no_color) && terminal && std::string_view(terminal) != "dumb";
}

} // namespace

std::string painted(const std::string& text, Color color, int file, bool for_line_editor) {
  if (!has_colors(file)) return text;
  const std::string on = "\033[" + std::to_string(static_cast<int>(color)) + "m", off = "\033[0m";
  if (!for_line_editor) return on + text + off;
  const auto bracketed = [](const std::string& code) { return '\001' + code + '\002'; };
  return bracketed(on) + text + bracketed(off);
}

} // namespace signorini::repl
