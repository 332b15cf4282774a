#include "base/interrupt.hpp"
#include "base/timer.hpp"
#include "bind/arguments.hpp"
#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/threads.hpp"

#include <charconv>
#include <filesystem>

namespace signorini::bind {

namespace {

/// core.fail(message): ends with an error at the line of the user's own script.
int core_fail(lua_State* L) {
  luaL_tolstring(L, 1, nullptr);
  push(L, user_position(L) + lua_tostring(L, -1));
  return lua_error(L);
}

/// core.now(), sg.wall_time(): wall-clock seconds since some moment in the past.
int now(lua_State* L) {
  static const Stopwatch since_start;
  push(L, since_start.seconds());
  return 1;
}

/// core.mkdir(path), sg.mkdir(path): makes a folder and those above it; an existing folder is fine.
int mkdir(lua_State* L) {
  const auto path = to<std::string>(L, 1);
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path))
    fail("cannot make the folder '", path, "' (", error ? error.message() : "it is a file",
         "): choose a place that can be written to");
  return 0;
}

/// core.describe(value): a value in the words of error messages.
int core_describe(lua_State* L) {
  push(L, describe(L, 1));
  return 1;
}

/// core.nearest(word, words): the word of a list that is nearest, or nil.
int core_nearest(lua_State* L) {
  const auto word = to<std::string>(L, 1);
  const auto words = to<std::vector<std::string>>(L, 2);
  const std::string best = nearest(word, words);
  if (best.empty()) return 0;
  push(L, best);
  return 1;
}

/// core.exists(path): whether there is a file or a folder of that name.
int core_exists(lua_State* L) {
  push(L, std::filesystem::exists(to<std::string>(L, 1)));
  return 1;
}

/// core.set_threads(threads): how many threads work on a solve from now on; core.threads is what --threads said.
int core_set_threads(lua_State* L) {
  set_threads(to<int>(L, 1));
  return 0;
}

/// core.number_text(value): the shortest decimal text of a finite number that reads back as the same number.
int core_number_text(lua_State* L) {
  char digits[32];
  const auto text_of = [&](auto value, auto... format) {
    return std::string_view(digits, std::to_chars(digits, digits + sizeof digits, value, format...).ptr);
  };
  if (lua_isinteger(L, 1)) {
    push(L, std::string(text_of(lua_tointeger(L, 1))));
    return 1;
  }
  const double value = luaL_checknumber(L, 1);
  std::string_view shortest;
  double again = 0;
  for (int precision = 15; precision <= 17; ++precision) {
    shortest = text_of(value, std::chars_format::general, precision);
    std::from_chars(shortest.begin(), shortest.end(), again);
    if (again == value) break;
  }
  lua_pushlstring(L, shortest.data(), shortest.size());
  return 1;
}

/// core.kind(value): the type, with the names of the program's own types such as "patch".
int kind(lua_State* L) {
  if (lua_isuserdata(L, 1) && luaL_getmetafield(L, 1, "__name") == LUA_TSTRING) return 1;
  push(L, luaL_typename(L, 1));
  return 1;
}

/// core.answer_interrupt(): whether Ctrl-C was pressed; if so, what is going on ends because of it and returns what it
/// has.
int core_answer_interrupt(lua_State* L) {
  if (interrupted()) answer_interrupt();
  push(L, interrupted());
  return 1;
}

int results(lua_State* L, int, lua_KContext) {
  return lua_gettop(L);
}

/// Calls the first upvalue; coroutines may yield across it.
int call_offered(lua_State* L) {
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_callk(L, lua_gettop(L) - 1, LUA_MULTRET, 0, results);
  return results(L, LUA_OK, 0);
}

/// core.offered(f): the function as users get it. Errors find their line also behind `return f()`: a tail call of a
/// function in Lua drops the caller, one of a function in C does not.
int core_offered(lua_State* L) {
  luaL_checktype(L, 1, LUA_TFUNCTION);
  lua_settop(L, 1);
  lua_pushcclosure(L, wrap<call_offered>, 1);
  return 1;
}

constexpr Function core_entries[] = {
    {"fail", core_fail},
    {"offered", core_offered},
    {"answer_interrupt", core_answer_interrupt},
    {"now", now},
    {"mkdir", mkdir},
    {"exists", core_exists},
    {"set_threads", core_set_threads},
    {"describe", core_describe},
    {"nearest", core_nearest},
    {"number_text", core_number_text},
    {"kind", kind},
};

constexpr Function public_rows[] = {
    {"mkdir", mkdir},
    {"wall_time", now},
};

} // namespace

void open_core(lua_State* L) {
  register_functions(L, "core", core_entries);
  register_functions(L, "sg", public_rows);
}

} // namespace signorini::bind
