#include "repl/chunk.hpp"

#include "base/match.hpp"
#include "bind/lua/stack.hpp"

#include <cstring>
#include <sstream>

namespace signorini::repl {

namespace {

/// True if a syntax error only means that the chunk continues on the next line.
bool unfinished(const std::string& message) {
  return message.ends_with("<eof>");
}

/// True if compilation of statements fails at their first word: then an expression was meant.
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

/// True if a line may be a command, which is not valid Lua: it begins with %, ? or !, ends with ?, or is "help
/// sg.body".
bool may_hold_commands(const std::string& code) {
  std::istringstream lines(code);
  for (std::string line; std::getline(lines, line);) {
    const auto first = line.find_first_not_of(" \t"), last = line.find_last_not_of(" \t");
    if (first == std::string::npos) continue;
    if (std::strchr("%?!", line[first]) || line[last] == '?' || line.compare(first, 5, "help ") == 0) return true;
  }
  return false;
}

/// True if code runs on its own.
bool is_whole(lua_State* L, const std::string& code) {
  const Chunk chunk = load(L, code);
  return chunk != Chunk::unfinished && lua_isfunction(L, 1);
}

} // namespace

void push_library_function(lua_State* L, const char* module, const char* name) {
  bind::push_require(L);
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

bool translate_commands(lua_State* L, std::string& code) {
  if (!may_hold_commands(code)) return true;
  push_library_function(L, "signorini.prompt.commands", "translate");
  bind::push(L, code);
  if (lua_pcall(L, 1, 1, 0) != LUA_OK) return false;
  code = lua_tostring(L, -1);
  lua_pop(L, 1);
  return true;
}

Chunk load_lua(lua_State* L, const std::string& code, const std::string& name) {
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

Chunk load(lua_State* L, std::string code, const std::string& name) {
  lua_settop(L, 0);
  return translate_commands(L, code) ? load_lua(L, code, name) : Chunk::statements;
}

std::vector<std::string> statements(lua_State* L, const std::string& code) {
  std::vector<std::string> found;
  std::istringstream lines(code);
  std::string block;
  for (std::string line; std::getline(lines, line);) {
    block += (block.empty() ? "" : "\n") + line;
    if (block.find_first_not_of(" \t\n") == std::string::npos) {
      block.clear();
    } else if (is_whole(L, block)) {
      found.push_back(block);
      block.clear();
    } else if (!found.empty() && is_whole(L, found.back() + "\n" + block)) { // a line such as ".. text" continues it
      found.back() += "\n" + block;
      block.clear();
    }
  }
  if (!block.empty()) found.push_back(block);
  lua_settop(L, 0);
  return found;
}

} // namespace signorini::repl
