#include "repl/interpreter.hpp"

#include "base/match.hpp"
#include "base/text.hpp"
#include "bind/lua/functions.hpp"
#include "bind/lua/limits.hpp"
#include "bind/lua/message.hpp"
#include "os/interrupt.hpp"
#include "os/limits.hpp"
#include "repl/color.hpp"
#include "repl/command_line.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <set>
#include <sstream>
#include <string_view>
#include <unistd.h>
#include <utility>

namespace signorini::repl {

namespace {

/// True if an error is meant for the user of the command, such as a wrong argument
/// (lua/signorini/call/script_arguments.lua).
bool is_refusal(lua_State* L) {
  const bool found = luaL_getmetafield(L, 1, "without_traceback") != LUA_TNIL;
  if (found) lua_pop(L, 1);
  return found;
}

/// The number of frames on the stack.
int stack_depth(lua_State* L) {
  lua_Debug frame;
  int known = 0, beyond = 1;
  while (lua_getstack(L, beyond, &frame)) known = std::exchange(beyond, 2 * beyond);
  while (beyond - known > 1) {
    const int middle = known + (beyond - known) / 2;
    (lua_getstack(L, middle, &frame) ? known : beyond) = middle;
  }
  return beyond;
}

/// The names of library and C frames in tracebacks, which list the first and the last frames of a deep stack.
std::set<std::string> library_places(lua_State* L) {
  constexpr int listed = 12; // at each end, at least
  bind::push_table(L, "core");
  lua_getfield(L, -1, "home");
  const std::string library = text("@", lua_tostring(L, -1), "/lua/");
  lua_pop(L, 2);
  std::set<std::string> places;
  lua_Debug frame;
  const int depth = stack_depth(L);
  for (int level = 1; level < depth; ++level) {
    if (level > listed && level < depth - listed) level = depth - listed;
    lua_getstack(L, level, &frame);
    lua_getinfo(L, "S", &frame);
    if (*frame.what == 'C' || std::string_view(frame.source).starts_with(library))
      places.insert(text(frame.short_src, ":"));
  }
  return places;
}

/// A traceback without the frames of the library and of C, which do not concern authors of scripts. All frames remain
/// if the message itself refers to a position in the library, where the error then is.
std::string users_frames(lua_State* L, const std::string& traceback) {
  std::set<std::string> places = library_places(L);
  const auto in_library = [&](std::string_view line) {
    return std::any_of(places.begin(), places.end(), [&](const std::string& place) { return line.starts_with(place); });
  };
  if (in_library(traceback)) return traceback;
  places.insert("(...tail calls...)");
  std::istringstream lines(traceback);
  std::string kept;
  bool in_frames = false;
  for (std::string line; std::getline(lines, line);) {
    const bool is_frame = in_frames && line.starts_with('\t'); // a message may contain a traceback, too
    if (!is_frame || !in_library(std::string_view(line).substr(1))) kept += (kept.empty() ? "" : "\n") + line;
    in_frames = in_frames || line == "stack traceback:";
  }
  return kept;
}

/// Message handler: converts any error value to text, followed by the script's traceback except for interrupts and
/// errors without traceback, or if it is shown later only. core.traceback is the complete one.
int add_traceback(lua_State* L) {
  const bool later = lua_toboolean(L, lua_upvalueindex(1)), refusal = is_refusal(L);
  bind::push_error_text(L, 1);
  if (interrupted() || refusal) return 1;
  luaL_traceback(L, L, lua_tostring(L, -1), 1);
  const std::string traceback = lua_tostring(L, -1);
  bind::push_table(L, "core");
  bind::set_field(L, "traceback", traceback);
  lua_pop(L, 2);
  if (!later) bind::push(L, users_frames(L, traceback));
  return 1;
}

int open_all(lua_State* L) {
  bind::open_library(L, *static_cast<const bind::Settings*>(lua_touserdata(L, 1)));
  const auto& settings = *static_cast<const bind::Settings*>(lua_touserdata(L, 1));
  bind::push_table(L, "core");
  bind::set_field(L, "options", option_texts()); // for share/cmake/generated.lua
  lua_pop(L, 1);
  // Before the first module that keeps a function of Lua for itself.
  luaL_loadstring(L,
                  settings.sandbox.empty() ? "require 'signorini.call.strict'" : "require 'signorini.prompt.sandbox'");
  lua_call(L, 0, 0);
  return 0;
}

} // namespace

Interpreter::Interpreter(const bind::Settings& settings) : state_(luaL_newstate()) {
  lua_State* L = state();
  lua_pushcfunction(L, bind::wrap<open_all>);
  lua_pushlightuserdata(L, const_cast<bind::Settings*>(&settings));
  if (lua_pcall(L, 1, 0, 0) != LUA_OK) bind::fail(lua_tostring(L, -1));
}

void Interpreter::set_arguments(const std::string& program, const std::string& script,
                                const std::vector<std::string>& arguments) {
  lua_State* L = state();
  bind::push(L, arguments);
  bind::push(L, script);
  lua_rawseti(L, -2, 0);
  bind::push(L, program);
  lua_rawseti(L, -2, -1);
  lua_setglobal(L, "arg");
  bind::push_table(L, "core"); // `arg` is the script's, which may change it
  bind::set_field(L, "script", script);
  bind::set_field(L, "arguments", arguments);
  lua_pop(L, 1);
  if (script.empty() || script == "-") return;
  const std::filesystem::path folder = std::filesystem::path(script).parent_path();
  lua_getglobal(L, "package");
  lua_getfield(L, -1, "path");
  // After the library, so that a script with the name of a library module does not hide it.
  const std::string path = lua_tostring(L, -1), own = (folder.empty() ? "." : folder.string()) + "/?.lua";
  const auto end = path.find(';');
  bind::push(L, path.substr(0, end) + ";" + own + path.substr(end));
  lua_setfield(L, -3, "path");
  lua_pop(L, 2);
}

bool Interpreter::open_globals() {
  return run_code("sg = require 'signorini'; help = sg.help", "=signorini");
}

bool Interpreter::call(int arguments, bool keep_traceback) {
  lua_State* L = state();
  const int base = lua_gettop(L) - arguments;
  lua_pushboolean(L, keep_traceback);
  lua_pushcclosure(L, add_traceback, 1);
  lua_insert(L, base);
  // What lines after a lack of memory have set free is not collected by allocations of C++.
  if (short_of_memory_) lua_gc(L, LUA_GCCOLLECT);
  const int status = lua_pcall(L, arguments, LUA_MULTRET, base);
  lua_remove(L, base);
  if (status == LUA_ERRMEM) {
    const MemoryReserve reserve;
    lua_pop(L, 1);
    lua_gc(L, LUA_GCCOLLECT);
    short_of_memory_ = true;
    bind::push(L, bind::missing_lua_memory());
  }
  return status == LUA_OK;
}

bool Interpreter::report(bool ok) {
  std::fflush(stdout);
  if (!ok) // in one piece, between which the output of other processes cannot come
    std::cerr << text(painted("signorini:", Color::red, STDERR_FILENO), " ", lua_tostring(state(), -1), "\n");
  lua_settop(state(), 0);
  return ok;
}

void add_syntax_hint(lua_State* L) {
  // Lua's messages for the first byte of a non-ASCII character, and for a missing comma between table entries.
  constexpr const char *beyond_ascii = ".*near '<\\\\(12[89]|1[3-9][0-9]|2[0-9][0-9])>'",
                       *comma = ".*'\\}' expected (\\(to close .*\\) )?near '.*'";
  const std::string message = lua_tostring(L, -1);
  const char* hint = !match(message, beyond_ascii).empty()
                         ? ". Hint: names consist of a-z, A-Z, digits and _; put other characters in quotes"
                     : !match(message, comma).empty() ? ". Hint: a comma may be missing before it"
                                                      : nullptr;
  if (!hint) return;
  lua_pop(L, 1);
  bind::push(L, message + hint);
}

bool Interpreter::run_code(const std::string& code, const std::string& name) {
  lua_State* L = state();
  const bool loaded = luaL_loadbufferx(L, code.data(), code.size(), name.c_str(), "t") == LUA_OK;
  if (!loaded) add_syntax_hint(L);
  return report(loaded && call(0));
}

bool Interpreter::run_file(const std::string& file, const std::vector<std::string>& arguments) {
  lua_State* L = state();
  if (luaL_loadfilex(L, file == "-" ? nullptr : file.c_str(), "t") != LUA_OK) {
    add_syntax_hint(L);
    return report(false);
  }
  luaL_checkstack(L, static_cast<int>(arguments.size()), "too many arguments");
  for (const auto& argument : arguments) bind::push(L, argument);
  const bool ok = call(static_cast<int>(arguments.size()));
  if (ok && lua_gettop(L) > 0) { // the prompt's name of the last result
    lua_pushglobaltable(L);
    bind::push(L, "_");
    lua_pushvalue(L, 1);
    lua_rawset(L, -3);
  }
  return report(ok);
}

bool Interpreter::lost_cases() const {
  lua_State* L = state();
  bind::push_table(L, "core");
  lua_getfield(L, -1, "lost_cases");
  const bool lost = lua_toboolean(L, -1);
  lua_pop(L, 2);
  return lost;
}

} // namespace signorini::repl
