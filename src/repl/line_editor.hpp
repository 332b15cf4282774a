#pragma once
// One line of input from readline, with history on disk, completion by Lua, and Ctrl-C as "forget this line".

#include <lua.hpp>

#include <string>

namespace signorini::repl {

enum class Input { line, interrupted, end };

/// Line editing for a terminal; there is one terminal, so there is one editor at a time.
class LineEditor {
public:
  explicit LineEditor(lua_State* L);
  /// `before`: the lines of the unfinished statement above this one, for completion.
  Input read(const char* prompt, const std::string& before, std::string& line);
  /// Adds a line to the history, in memory and on disk.
  void remember(const std::string& line);

private:
  std::string history_file_;
};

std::string readline_version();

} // namespace signorini::repl
