#include "repl/prompt.hpp"

#include "os/limits.hpp"
#include "repl/chunk.hpp"
#include "repl/color.hpp"
#include "repl/execution.hpp"
#include "repl/line_editor.hpp"

#include <iostream>
#include <optional>
#include <unistd.h>

namespace signorini::repl {

namespace {

/// Runs the result of load() and prints its results.
bool run(Interpreter& interpreter, Chunk chunk, const std::string& code) {
  start_time_limit();
  const Execution execution = execute(interpreter, chunk, code, {"signorini.prompt.prompt", "results"}, true);
  if (!execution.ok) std::cerr << painted(execution.message, Color::red, STDERR_FILENO) << std::endl;
  lua_settop(interpreter.state(), 0);
  return execution.ok;
}

} // namespace

bool prompt(Interpreter& interpreter, bool quiet) {
  lua_State* L = interpreter.state();
  std::optional<LineEditor> editor;
  push_library_function(L, "signorini.prompt.prompt", "traceback");
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
    // Variables may hold all of the memory: the statement that frees it must be read.
    std::optional<MemoryReserve> reserve(std::in_place);
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
    if (editor)
      for (const std::string& statement : statements(L, code)) editor->remember(statement);
    const Chunk chunk = load(L, code);
    reserve.reset();
    all_well = run(interpreter, chunk, code) && all_well;
    code.clear();
  }
  if (!code.empty()) {
    std::cerr << "prompt: the input ends inside a statement" << std::endl;
    all_well = false;
  }
  return all_well || editor;
}

} // namespace signorini::repl
