#include "repl/colour.hpp"

#include <cstdlib>
#include <string_view>
#include <unistd.h>

namespace signorini::repl {

namespace {

bool has_colours(int file) {
  const char *no_colour = std::getenv("NO_COLOR"), *terminal = std::getenv("TERM");
  return isatty(file) && !(no_colour && *no_colour) && terminal && std::string_view(terminal) != "dumb";
}

} // namespace

std::string painted(const std::string& text, Colour colour, int file, bool for_line_editor) {
  if (!has_colours(file)) return text;
  const std::string on = "\033[" + std::to_string(static_cast<int>(colour)) + "m", off = "\033[0m";
  if (!for_line_editor) return on + text + off;
  const auto bracketed = [](const std::string& code) { return '\001' + code + '\002'; };
  return bracketed(on) + text + bracketed(off);
}

} // namespace signorini::repl
