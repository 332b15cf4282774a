// Cells of a notebook as executable code.

#include "base/text.hpp"
#include "repl/chunk.hpp"

#include <cstring>

namespace signorini::repl {

namespace {

bool is_chunk(lua_State* L, const std::string& code) {
  const bool ok = luaL_loadbufferx(L, code.data(), code.size(), "=", "t") == LUA_OK;
  lua_pop(L, 1);
  return ok;
}

/// True if Lua may read a text as the continuation of the line before: a call, or an operation.
bool may_continue(const std::string& code) {
  const auto begin = code.find_first_not_of(" \t\n");
  return begin != std::string::npos && std::strchr("({['\"-~", code[begin]) != nullptr;
}

/// The code with a return before the expression at its end, which begins a line or follows a semicolon; empty if there
/// is none. `whole`: all of the code is valid as statements.
std::string with_last_expression(lua_State* L, const std::string& code, bool whole) {
  for (auto at = code.find_last_of(";\n"); at != std::string::npos && at > 0; at = code.find_last_of(";\n", at - 1)) {
    const std::string before = code.substr(0, at + 1), last = text("return nil, ", code.substr(at + 1));
    if (whole && may_continue(code.substr(at + 1))) continue;
    if (is_chunk(L, last) && is_chunk(L, before)) return before + last;
  }
  return "";
}

} // namespace

Chunk load_cell(lua_State* L, std::string code, const std::string& name) {
  lua_settop(L, 0);
  if (!translate_commands(L, code)) return Chunk::statements;
  const Chunk chunk = load_lua(L, code, name);
  if (chunk == Chunk::expression) return chunk;
  const std::string with_result = with_last_expression(L, code, lua_isfunction(L, 1));
  if (with_result.empty()) return chunk;
  lua_settop(L, 0);
  luaL_loadbufferx(L, with_result.data(), with_result.size(), ("=" + name).c_str(), "t");
  return Chunk::expression;
}

} // namespace signorini::repl
