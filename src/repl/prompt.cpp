#include "repl/prompt.hpp"

#include "base/interrupt.hpp"
#include "bind/functions.hpp"
#include "repl/colour.hpp"
#include "repl/interrupt.hpp"
#include "repl/line_editor.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <optional>
#include <unistd.h>

namespace signorini::repl {

namespace {

/// Whether a syntax error only says that the chunk goes on in the next line.
bool unfinished(const std::string& message) {
  return message.ends_with("<eof>");
}

/// Pushes a function of a module of the library.
void push_library_function(lua_State* L, const char* module, const char* name) {
  lua_getglobal(L, "require");
  bind::push(L, module);
  lua_call(L, 1, 1);
  lua_getfield(L, -1, name);
  lua_remove(L, -2);
}

/// Lets errors about undefined variables know which ones were local to a line.
void note_locals(lua_State* L, const std::string& code) {
  push_library_function(L, "signorini.prompt", "note_locals");
  bind::push(L, code);
  lua_call(L, 1, 0);
}

enum class Chunk { unfinished, statements, expression };

/// Whether statements fail at their first word: then they were meant as an expression.
bool is_no_statement(const std::string& code, std::string message) {
  const std::string begin = "unexpected symbol near '";
  const auto at = message.find(begin);
  if (at == std::string::npos) return false;
  message = message.substr(at + begin.size());
  message.pop_back();
  return code.substr(code.find_first_not_of(" \t\n")).starts_with(message);
}

/// Pushes the code as a function, or an error message.
bool compiles(lua_State* L, const std::string& code) {
  return luaL_loadbufferx(L, code.data(), code.size(), "=prompt", "t") == LUA_OK;
}

/// Code whose last line stands behind a return: lines that were pasted together may end with an expression.
std::string with_result(const std::string& code) {
  const auto end = code.find_last_not_of(" \t\n"), line = code.rfind('\n', end) + 1;
  return text(code.substr(0, line), "return nil, ", code.substr(line));
}

/// What a line asks help for: "?sg.body", or "help sg.body", which is no Lua; nothing in other lines.
std::optional<std::string> query(const std::string& code) {
  const auto begin = code.find_first_not_of(" \t");
  if (code[begin] == '?') return code.substr(begin + 1);
  if (code.compare(begin, 5, "help ") != 0) return {};
  const auto first = code.find_first_not_of(' ', begin + 5), last = code.find_last_not_of(' ');
  const std::string word = first == std::string::npos ? "" : code.substr(first, last + 1 - first);
  const bool is_path = std::all_of(word.begin(), word.end(),
                                   [](unsigned char c) { return std::isalnum(c) || (c && std::strchr("_.:", c)); });
  return is_path && !word.empty() && std::isalpha(static_cast<unsigned char>(word.front())) ? std::optional(word)
                                                                                            : std::nullopt;
}

/// Loads the lines so far as an expression or as statements, or as a query for help, and leaves a function
/// and its arguments, or an error message, alone on the stack. An expression stands behind a nil, so that a call in it
/// is no tail call, which would lose its place in errors.
Chunk load(lua_State* L, const std::string& code) {
  lua_settop(L, 0);
  if (const auto wanted = query(code)) {
    push_library_function(L, "signorini.help", "ask");
    bind::push(L, *wanted);
    return Chunk::statements;
  }
  if (compiles(L, text("return nil, ", code))) return Chunk::expression;
  const bool well = compiles(L, code);
  lua_remove(L, well || !is_no_statement(code, lua_tostring(L, -1)) ? 1 : 2);
  if (well) return Chunk::statements;
  if (unfinished(lua_tostring(L, 1))) return Chunk::unfinished;
  const bool has_result = code.find('\n') != std::string::npos && compiles(L, with_result(code));
  if (has_result) lua_insert(L, 1);
  lua_settop(L, 1);
  return has_result ? Chunk::expression : Chunk::statements;
}

/// Runs what load() left, and prints its results.
bool run(Interpreter& interpreter, Chunk chunk) {
  lua_State* L = interpreter.state();
  bool ok = lua_isfunction(L, 1) && interpreter.call(lua_gettop(L) - 1, true);
  if (ok) {
    if (chunk == Chunk::expression) lua_remove(L, 1);
    push_library_function(L, "signorini.prompt", "results");
    lua_insert(L, 1);
    ok = interpreter.call(lua_gettop(L) - 1, true);
  }
  std::fflush(stdout);
  const bool stopped = interrupted();
  forget_interrupt(L);
  if (!ok && stopped) {
    push_library_function(L, "signorini.prompt", "interrupted");
    interpreter.call(0, true);
  }
  if (!ok) std::cerr << painted(lua_tostring(L, -1), Colour::red, STDERR_FILENO) << std::endl;
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
    if (!quiet) std::cout << "signorini " SIGNORINI_VERSION "; help() helps, Ctrl-D leaves" << std::endl;
  }
  std::string code;
  const auto read = [&](const std::string& sign, std::string& line) {
    if (editor) return editor->read(sign.c_str(), code, line);
    return std::getline(std::cin, line) ? Input::line : Input::end;
  };

  const std::string first = painted("sg> ", Colour::green, STDOUT_FILENO, true),
                    next = painted("..> ", Colour::green, STDOUT_FILENO, true);
  bool all_well = true;
  std::string line;
  for (;;) {
    const Input input = read(code.empty() ? first : next, line);
    const bool leave = input == Input::end && (!editor || code.empty()); // else Ctrl-D leaves the unfinished statement
    if (leave) break;
    if (input != Input::line) {
      code.clear();
      continue;
    }
    if (editor) editor->remember(line);
    code += (code.empty() ? "" : "\n") + line;
    if (code.find_first_not_of(" \t\n") == std::string::npos) {
      code.clear();
      continue;
    }
    const Chunk chunk = load(L, code);
    if (chunk == Chunk::unfinished) continue;
    note_locals(L, code);
    code.clear();
    all_well = run(interpreter, chunk) && all_well;
  }
  if (!code.empty()) {
    std::cerr << "prompt: the input ends inside a statement" << std::endl;
    all_well = false;
  }
  return all_well || editor;
}

} // namespace signorini::repl
