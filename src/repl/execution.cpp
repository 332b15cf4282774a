#include "repl/execution.hpp"

#include "bind/lua/stack.hpp"
#include "os/interrupt.hpp"
#include "os/limits.hpp"
#include "repl/interrupt.hpp"

#include <cstdio>

namespace signorini::repl {

namespace {

/// Records local variables of a line for error messages about undefined variables.
void note_locals(lua_State* L, const std::string& code) {
  push_library_function(L, "signorini.prompt.prompt", "note_locals");
  bind::push(L, code);
  lua_call(L, 1, 0);
}

} // namespace

Execution execute(Interpreter& interpreter, Chunk chunk, const std::string& code, const LibraryFunction& results,
                  bool keep_traceback) {
  lua_State* L = interpreter.state();
  {
    const MemoryReserve reserve;
    note_locals(L, code);
  }
  if (!lua_isfunction(L, 1)) add_syntax_hint(L);
  Execution execution;
  execution.ok = lua_isfunction(L, 1) && interpreter.call(lua_gettop(L) - 1, keep_traceback);
  const MemoryReserve reserve;
  if (execution.ok) {
    if (chunk == Chunk::expression) lua_remove(L, 1);
    push_library_function(L, results.module, results.name);
    lua_insert(L, 1);
    execution.ok = interpreter.call(lua_gettop(L) - 1, keep_traceback);
  }
  std::fflush(stdout);
  execution.was_interrupted = interrupted();
  execution.ok = execution.ok && !execution.was_interrupted;
  forget_interrupt(L);
  if (execution.was_interrupted) {
    push_library_function(L, "signorini.prompt.prompt", "interrupted");
    interpreter.call(0, keep_traceback);
  }
  if (!execution.ok) execution.message = lua_tostring(L, -1);
  return execution;
}

} // namespace signorini::repl
