#include "repl/interrupt.hpp"

#include "base/interrupt.hpp"
#include "bind/message.hpp"

#include <csignal>
#include <string_view>

namespace signorini::repl {

namespace {

lua_State* running = nullptr;
void (*raise_flag)(int) = nullptr;

void stop(lua_State* L, lua_Debug* frame) {
  if (!interrupted()) {
    lua_sethook(L, nullptr, 0, 0);
    return;
  }
  lua_getinfo(L, "S", frame);
  if (std::string_view(frame->what) == "C" || bind::in_library(L, *frame)) return;
  luaL_where(L, 0);
  lua_pushstring(L, "interrupted");
  lua_concat(L, 2);
  lua_error(L);
}

/// lua_sethook is the one function of Lua that may be called from a signal handler.
void on_interrupt(int signal) {
  raise_flag(signal);
  lua_sethook(running, stop, LUA_MASKCALL | LUA_MASKRET | LUA_MASKLINE | LUA_MASKCOUNT, 1);
}

} // namespace

void catch_interrupts(lua_State* L) {
  running = L;
  signorini::catch_interrupts();
  raise_flag = std::signal(SIGINT, on_interrupt);
}

void forget_interrupt(lua_State* L) {
  clear_interrupt();
  lua_sethook(L, nullptr, 0, 0);
}

} // namespace signorini::repl
