#include "repl/chunk.hpp"

#include "base/match.hpp"
#include "bind/stack.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <optional>

namespace signorini::repl {

namespace {

/// Whether a syntax error only means that the chunk continues on the next line.
bool unfinished(const std::string& message) {
  return message.ends_with("<eof>");
}

/// Whether compilation of statements fails at their first word: then an expression was meant.
bool is_no_statement(const std::string& code, std::string message) {
  const std::string begin = "unexpected symbol near '";
  const auto at = message.find(begin);
  if (at == std::string::npos) return false;
  message = message.substr(at + begin.size());
  message.pop_back();
  return code.substr(code.find_first_not_of(" \t\n")).starts_with(message);
}

/// Pushes the compiled code, or an error message.
bool compiles(lua_State* L, const std::string& code, const std::string& name) {
  const std::string line = code + "\n"; // an unclosed quotation mark is an error of its own line
  return luaL_loadbufferx(L, line.data(), line.size(), ("=" + name).c_str(), "t") == LUA_OK;
}

/// Inserts a return before the last line: several pasted lines may end with an expression.
std::string with_result(const std::string& code) {
  const auto end = code.find_last_not_of(" \t\n"), line = code.rfind('\n', end) + 1;
  return text(code.substr(0, line), "return nil, ", code.substr(line));
}

/// The query of a line "?sg.body" or "help sg.body" (not valid Lua); empty for other lines.
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

} // namespace

void push_library_function(lua_State* L, const char* module, const char* name) {
  lua_getglobal(L, "require");
  bind::push(L, module);
  lua_call(L, 1, 1);
  lua_getfield(L, -1, name);
  lua_remove(L, -2);
}

bool asks_to_leave(lua_State* L, const std::string& line) {
  const auto found = match(line, "[[:space:]]*(exit|quit)[[:space:]]*(\\([[:space:]]*\\))?[[:space:]]*;?[[:space:]]*");
  if (found.empty()) return false;
  lua_pushglobaltable(L);
  bind::push(L, found[1]);
  const bool is_free = lua_rawget(L, -2) == LUA_TNIL;
  lua_pop(L, 2);
  return is_free;
}

Chunk load(lua_State* L, const std::string& code, const std::string& name) {
  lua_settop(L, 0);
  if (const auto wanted = query(code)) {
    push_library_function(L, "signorini.help", "ask");
    bind::push(L, *wanted);
    return Chunk::statements;
  }
  if (compiles(L, text("return nil, ", code), name)) return Chunk::expression;
  const bool well = compiles(L, code, name);
  lua_remove(L, well || !is_no_statement(code, lua_tostring(L, -1)) ? 1 : 2);
  if (well) return Chunk::statements;
  if (unfinished(lua_tostring(L, 1))) return Chunk::unfinished;
  const bool has_result = code.find('\n') != std::string::npos && compiles(L, with_result(code), name);
  if (has_result) lua_insert(L, 1);
  lua_settop(L, 1);
  return has_result ? Chunk::expression : Chunk::statements;
}

} // namespace signorini::repl
