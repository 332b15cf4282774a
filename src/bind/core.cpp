#include "base/interrupt.hpp"
#include "base/timer.hpp"
#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/threads.hpp"

#include <charconv>
#include <filesystem>
#include <limits>

namespace signorini::bind {

namespace {

int core_fail(lua_State* L) {
  luaL_tolstring(L, 1, nullptr);
  push(L, user_position(L) + lua_tostring(L, -1));
  return lua_error(L);
}

int now(lua_State* L) {
  static const Stopwatch since_start;
  push(L, since_start.seconds());
  return 1;
}

int mkdir(lua_State* L) {
  const std::string path = read_string(L, 1, {"path", "a folder"});
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path))
    fail("cannot make the folder '", path, "' (", error ? error.message() : "it is a file",
         "): choose a place that can be written to");
  return 0;
}

int core_describe(lua_State* L) {
  push(L, describe(L, 1));
  return 1;
}

int core_nearest(lua_State* L) {
  const std::string word = read_string(L, 1, {"word"});
  const int count = read_list(L, 2, {"words"});
  std::vector<std::string> words;
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, 2, i);
    words.push_back(read_string(L, -1, {text("words[", i, "]")}));
    lua_pop(L, 1);
  }
  const std::string best = nearest(word, words);
  if (best.empty()) return 0;
  push(L, best);
  return 1;
}

int core_exists(lua_State* L) {
  push(L, std::filesystem::exists(read_string(L, 1, {"path"})));
  return 1;
}

int core_set_threads(lua_State* L) {
  set_threads(read_integer(L, 1, {"threads", "how many work on a solve"}, 1, most_threads));
  return 0;
}

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

int kind(lua_State* L) {
  if (lua_isuserdata(L, 1) && luaL_getmetafield(L, 1, "__name") == LUA_TSTRING) return 1;
  push(L, luaL_typename(L, 1));
  return 1;
}

int core_answer_interrupt(lua_State* L) {
  if (interrupted()) answer_interrupt();
  push(L, interrupted());
  return 1;
}

int results(lua_State* L, int, lua_KContext) {
  return lua_gettop(L);
}

/// Calls the first upvalue with no more arguments than the second one allows; coroutines may yield across it.
int call_offered(lua_State* L) {
  if (const auto most = static_cast<int>(lua_tointeger(L, lua_upvalueindex(2))); arguments_given(L) > most) {
    lua_Debug running;
    lua_getstack(L, 0, &running);
    push_table(L, "core.names");
    lua_getinfo(L, "f", &running);
    if (lua_rawget(L, -2) == LUA_TSTRING) {
      const std::string name = lua_tostring(L, -1);
      push_table(L, "core.docs");
      lua_getfield(L, -1, name.c_str());
      const std::string head = lua_isstring(L, -1) ? head_of_call(lua_tostring(L, -1)) : "";
      lua_pop(L, 4);
      refuse_excess(L, name, head.empty() ? name : head, most);
    } else {
      lua_pop(L, 2);
    }
  }
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_callk(L, lua_gettop(L) - 1, LUA_MULTRET, 0, results);
  return results(L, LUA_OK, 0);
}

int core_offered(lua_State* L) {
  luaL_checktype(L, 1, LUA_TFUNCTION);
  lua_settop(L, 2);
  lua_Debug function;
  lua_pushvalue(L, 1);
  lua_getinfo(L, ">u", &function);
  const int most = function.isvararg ? std::numeric_limits<int>::max() : function.nparams;
  if (lua_isnil(L, 2)) {
    lua_pop(L, 1);
    push(L, most);
  }
  lua_pushcclosure(L, wrap<call_offered>, 2);
  return 1;
}

constexpr Function core_entries[] = {
    {"fail", core_fail, "core.fail(message)\nEnds with an error at the line of the user's own script."},
    {"offered", core_offered,
     "core.offered(f, most)\n"
     "The function as users get it. Errors find their line also behind `return f()`: a tail call of a function in\n"
     "Lua drops the caller, one of a function in C does not. It takes no more arguments than it looks at, or `most`."},
    {"answer_interrupt", core_answer_interrupt,
     "core.answer_interrupt()\nWhether Ctrl-C was pressed; if so, what is going on ends because of it and returns what "
     "it "
     "has."},
    {"now", now, "core.now()\nWall-clock seconds since some moment in the past."},
    {"mkdir", mkdir, "core.mkdir(path)\nMakes a folder and those above it; an existing folder is fine."},
    {"exists", core_exists, "core.exists(path)\nWhether there is a file or a folder of that name."},
    {"set_threads", core_set_threads,
     "core.set_threads(threads)\nHow many threads work on a solve from now on; core.threads is what --threads said."},
    {"describe", core_describe, "core.describe(value)\nA value in the words of error messages."},
    {"nearest", core_nearest, "core.nearest(word, words)\nThe word of a list that is nearest, or nil."},
    {"number_text", core_number_text,
     "core.number_text(value)\nThe shortest decimal text of a finite number that reads back as the same number."},
    {"kind", kind, "core.kind(value)\nThe type, with the names of the program's own types such as \"patch\"."},
};

constexpr Function public_rows[] = {
    {"mkdir", mkdir,
     "sg.mkdir(path)\nMakes a folder and those above it; an existing folder is fine.\nExample: sg.mkdir \"out/study\""},
    {"wall_time", now,
     "sg.wall_time()\n"
     "Wall-clock seconds since an arbitrary moment: the difference of two values is the time between two calls. For\n"
     "the processor time of all threads, take os.clock().\n"
     "Example: began = sg.wall_time(); model:run(stages); print(sg.wall_time() - began)"},
};

} // namespace

void open_core(lua_State* L) {
  register_functions(L, "core", core_entries);
  register_functions(L, "sg", public_rows);
}

} // namespace signorini::bind
