#include "repl/interrupt.hpp"

#include "bind/lua/coroutines.hpp"
#include "bind/lua/limits.hpp"
#include "bind/lua/message.hpp"
#include "bind/lua/stack.hpp"
#include "os/interrupt.hpp"
#include "os/limits.hpp"

#include <csignal>
#include <string_view>

namespace signorini::repl {

namespace {

void (*raise_flag)(int) = nullptr;
bool finishes_statements = false, ends_library = false;

/// True if an event in the user's code only completes a statement: results that a solve or study returned after Ctrl-C
/// are being assigned, through returns and metamethods of tables.
bool finishes_statement(lua_State* L, lua_Debug* frame) {
  if (!finishes_statements || !interrupt_reported() || frame->event == LUA_HOOKLINE) return false;
  if (frame->event != LUA_HOOKCALL && frame->event != LUA_HOOKTAILCALL) return true;
  lua_getinfo(L, "n", frame);
  return std::string_view(frame->namewhat) == "metamethod";
}

/// True if the user's code calls a function of C or of the library, such as print.
bool user_calls(lua_State* L, const lua_Debug& frame) {
  lua_Debug caller;
  if (frame.event != LUA_HOOKCALL || !lua_getstack(L, 1, &caller)) return false;
  lua_getinfo(L, "S", &caller);
  return std::string_view(caller.what) != "C" && !bind::in_library(L, caller);
}

void stop(lua_State* L, lua_Debug* frame) {
  if (!interrupted()) {
    lua_sethook(L, nullptr, 0, 0);
    return;
  }
  lua_getinfo(L, "S", frame);
  const bool own = ends_library || (std::string_view(frame->what) != "C" && !bind::in_library(L, *frame));
  if (!own && !(finishes_statements && interrupt_reported() && user_calls(L, *frame))) return;
  if (finishes_statement(L, frame)) return;
  luaL_where(L, 0);
  bind::push(L, bind::interruption());
  lua_concat(L, 2);
  lua_error(L);
}

/// lua_sethook is the only Lua function that signal handlers may call.
void set_hook() {
  lua_sethook(bind::running_thread(), stop, LUA_MASKCALL | LUA_MASKRET | LUA_MASKLINE | LUA_MASKCOUNT, 1);
}

void on_interrupt(int signal) {
  raise_flag(signal);
  set_hook();
}

} // namespace

void catch_interrupts() {
  signorini::catch_interrupts();
  raise_flag = std::signal(SIGINT, on_interrupt);
}

InterruptsLibrary::InterruptsLibrary() {
  ends_library = true;
}
InterruptsLibrary::~InterruptsLibrary() {
  ends_library = false;
}

void finish_statements() {
  finishes_statements = true;
}

void limit_time(double seconds, const std::string& written) {
  signorini::limit_time(seconds, written, set_hook);
}

void forget_interrupt(lua_State* L) {
  stop_time_limit();
  clear_interrupt();
  lua_sethook(L, nullptr, 0, 0);
}

} // namespace signorini::repl
