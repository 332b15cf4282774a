#pragma once
// Line input by readline, with history on disk, completion by Lua, and Ctrl-C to discard the line.

#include <lua.hpp>

#include <string>

namespace signorini::repl {

enum class Input { line, interrupted, end }; ///< a line that was pasted or recalled may be a block of several

/// Line editing on the terminal; only one instance at a time.
class LineEditor {
public:
  explicit LineEditor(lua_State* L);
  /// `before`: previous lines of the unfinished statement, for completion.
  Input read(const char* prompt, const std::string& before, std::string& line);
  /// Adds a statement, which may have several lines, to the history, in memory and on disk.
  void remember(const std::string& statement);

private:
  std::string history_file_;
};

std::string readline_version();

} // namespace signorini::repl
