#include "repl/prompt.hpp"

#include "base/interrupt.hpp"
#include "bind/stack.hpp"
#include "repl/chunk.hpp"
#include "repl/color.hpp"
#include "repl/interrupt.hpp"
#include "repl/line_editor.hpp"

#include <cstdio>
#include <iostream>
#include <optional>
#include <unistd.h>

namespace signorini::repl {

namespace {

/// Records local variables of a line for error messages about undefined variables.
void note_locals(lua_State* L, const std::string& code) {
  push_library_function(L, "signorini.prompt", "note_locals");
  bind::push(L, code);
  lua_call(L, 1, 0);
}

/// Runs the result of load() and prints its results.
bool run(Interpreter& interpreter, Chunk chunk) {
  lua_State* L = interpreter.state();
  if (!lua_isfunction(L, 1)) add_syntax_hint(L);
  bool ok = lua_isfunction(L, 1) && interpreter.call(0, true);
  if (ok) {
    if (chunk == Chunk::expression) lua_remove(L, 1);
    push_library_function(L, "signorini.prompt", "results");
    lua_insert(L, 1);
    ok = interpreter.call(lua_gettop(L) - 1, true);
  }
  std::fflush(stdout);
  const bool stopped = interrupted();
  ok = ok && !stopped;
  forget_interrupt(L);
  if (stopped) {
    push_library_function(L, "signorini.prompt", "interrupted");
    interpreter.call(0, true);
  }
  if (!ok) std::cerr << painted(lua_tostring(L, -1), Color::red, STDERR_FILENO) << std::endl;
  lua_settop(L, 0);
  return ok;
}

} // namespace

bool prompt(Interpreter& interpreter, bool quiet) {
  lua_State* L = interpreter.state();
  std::optional<LineEditor> editor;
  push_library_function(L, "signorini.prompt", "traceback");
  lua_setglobal(L, "traceback");
  if (isatty(STDIN_FILENO)) {
    editor.emplace(L);
    if (!quiet) std::cout << "signorini " SIGNORINI_VERSION "; help() shows help, Ctrl-D exits" << std::endl;
  }
  std::string code;
  const auto read = [&](const std::string& sign, std::string& line) {
    if (editor) return editor->read(sign.c_str(), code, line);
    return std::getline(std::cin, line) ? Input::line : Input::end;
  };

  const std::string first = painted("sg> ", Color::green, STDOUT_FILENO, true),
                    next = painted("..> ", Color::green, STDOUT_FILENO, true);
  bool all_well = true;
  std::string line;
  for (;;) {
    const Input input = read(code.empty() ? first : next, line);
    const bool leave =
        input == Input::end && (!editor || code.empty()); // otherwise Ctrl-D discards the unfinished statement
    if (leave) break;
    if (input != Input::line) {
      if (editor) editor->remember(code); // to be corrected
      code.clear();
      continue;
    }
    if (code.empty() && asks_to_leave(L, line)) {
      if (editor) editor->remember(line);
      break;
    }
    code += (code.empty() ? "" : "\n") + line;
    if (code.find_first_not_of(" \t\n") == std::string::npos) {
      code.clear();
      continue;
    }
    if (load(L, code) == Chunk::unfinished) continue;
    note_locals(L, code);
    if (editor)
      for (const std::string& statement : statements(L, code)) editor->remember(statement);
    all_well = run(interpreter, load(L, code)) && all_well;
    code.clear();
  }
  if (!code.empty()) {
    std::cerr << "prompt: the input ends inside a statement" << std::endl;
    all_well = false;
  }
  return all_well || editor;
}

} // namespace signorini::repl
