#include "repl/prompt.hpp"

#include "base/interrupt.hpp"
#include "bind/functions.hpp"
#include "repl/colour.hpp"
#include "repl/interrupt.hpp"
#include "repl/line_editor.hpp"

#include <cstdio>
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

/// Loads the lines so far as an expression or as statements, or as a query for help ("?sg.body"), and leaves a function
/// and its arguments, or an error message, on the stack. An expression stands behind a nil, so that a call in it is no
/// tail call, which would lose its place in errors.
Chunk load(lua_State* L, const std::string& code) {
  if (code.front() == '?') {
    push_library_function(L, "signorini.help", "ask");
    bind::push(L, code.substr(1));
    return Chunk::statements;
  }
  const std::string expression = text("return nil, ", code);
  if (luaL_loadbufferx(L, expression.data(), expression.size(), "=prompt", "t") == LUA_OK) return Chunk::expression;
  if (luaL_loadbufferx(L, code.data(), code.size(), "=prompt", "t") == LUA_OK ||
      !is_no_statement(code, lua_tostring(L, -1)))
    lua_remove(L, 1);
  else
    lua_settop(L, 1);
  return lua_isfunction(L, 1) || !unfinished(lua_tostring(L, 1)) ? Chunk::statements : Chunk::unfinished;
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
  if (!ok)
    std::cerr << painted(interrupted() ? "interrupted" : lua_tostring(L, -1), Colour::red, STDERR_FILENO) << std::endl;
  lua_settop(L, 0);
  forget_interrupt(L);
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
  for (Input input; (input = read(code.empty() ? first : next, line)) != Input::end;) {
    if (input == Input::interrupted) {
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
    if (chunk == Chunk::unfinished) {
      lua_settop(L, 0);
      continue;
    }
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
