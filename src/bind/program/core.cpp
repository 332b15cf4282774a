#include "base/base64.hpp"
#include "base/notice.hpp"
#include "bind/lua/arguments.hpp"
#include "bind/lua/functions.hpp"
#include "bind/lua/limits.hpp"
#include "bind/lua/open.hpp"
#include "bind/lua/threads.hpp"
#include "bind/program/library.hpp"
#include "os/archive.hpp"
#include "os/claim.hpp"
#include "os/interrupt.hpp"
#include "os/lock.hpp"
#include "os/timer.hpp"
#include "os/whole_file.hpp"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fmt/format.h>
#include <map>

namespace signorini::bind {

template <> struct Type<Lock> { static constexpr auto name = "lock"; };

namespace {

/// core.fail(message): raises an error at the line of the user's script.
int core_fail(lua_State* L) {
  luaL_tolstring(L, 1, nullptr);
  push(L, printable(user_position(L) + to<std::string>(L, -1)));
  return lua_error(L);
}

/// core.now(), sg.wall_time(): wall-clock seconds since an unspecified origin.
double now() {
  static const Stopwatch since_start;
  return since_start.seconds();
}

/// core.sleep(seconds): waits, at most until Ctrl-C; returns whether this was pressed.
bool sleep(double seconds) {
  const auto whole = static_cast<time_t>(seconds);
  const timespec time{whole, static_cast<long>((seconds - static_cast<double>(whole)) * 1e9)};
  if (!interrupted()) nanosleep(&time, nullptr);
  if (interrupted()) report_interrupt();
  return interrupted();
}

/// core.mkdir(path), sg.mkdir(path): creates a folder and its parents; existing folders are accepted.
void mkdir(const std::string& path) {
  check_file_name(path);
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path))
    fail("cannot create the folder '", path, "' (", error ? error.message() : "it is a file",
         "): choose a place with write permission");
}

/// core.describe(value): a value as error messages print it.
int core_describe(lua_State* L) {
  push(L, describe(L, 1));
  return 1;
}

/// core.nearest(word, words): the word of a list nearest by edit distance, or nil.
std::optional<std::string> core_nearest(const std::string& word, const std::vector<std::string>& words) {
  const std::string best = nearest(word, words);
  return best.empty() ? std::nullopt : std::optional(best);
}

/// core.write_output(file, bytes, kind): writes a file that the user has named atomically, if it may replace what there
/// is; kind "csv", "json", "html" or "vtk".
void core_write_output(const std::string& file, std::string_view bytes, const std::string& kind) {
  const std::map<std::string, FileKind> kinds = {
      {"csv", FileKind::table}, {"json", FileKind::json}, {"html", FileKind::html}, {"vtk", FileKind::vtk}};
  write_output(file, bytes, kinds.at(kind));
}

/// core.list_folder(folder): the sorted names of its entries.
std::vector<std::string> list_folder(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

/// core.number_text(value): the shortest decimal text that reads back as the same finite number.
int core_number_text(lua_State* L) {
  push(L, lua_isinteger(L, 1) ? fmt::to_string(lua_tointeger(L, 1)) : fmt::to_string(luaL_checknumber(L, 1)));
  return 1;
}

/// core.kind(value): the type, for objects of the program its name such as "patch".
int kind(lua_State* L) {
  if (lua_isuserdata(L, 1) && luaL_getmetafield(L, 1, "__name") == LUA_TSTRING) return 1;
  push(L, luaL_typename(L, 1));
  return 1;
}

/// core.answer_interrupt(): whether Ctrl-C was pressed; if so, marks it as handled, because the current operation ends
/// and returns its partial results.
bool core_answer_interrupt() {
  if (interrupted()) report_interrupt();
  return interrupted();
}

int results(lua_State* L, int, lua_KContext) {
  return lua_gettop(L);
}

/// Calls the first upvalue, with support for coroutines that yield across it.
int call_offered(lua_State* L) {
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_callk(L, lua_gettop(L) - 1, LUA_MULTRET, 0, results);
  return results(L, LUA_OK, 0);
}

/// core.offered(f): the function for users. Errors find their line also after `return f()`: a tail call of a Lua
/// function drops the caller from the stack, one of a C function does not.
int core_offered(lua_State* L) {
  luaL_checktype(L, 1, LUA_TFUNCTION);
  lua_settop(L, 1);
  lua_pushcclosure(L, wrap<call_offered>, 1);
  return 1;
}

constexpr Function core_entries[] = {
    {"fail", core_fail},
    {"offered", core_offered},
    {"answer_interrupt", call<core_answer_interrupt>},
    {"interruption", call<interruption>}, // see limits.hpp
    {"mute_warnings", call<mute_warnings>},
    {"now", call<now>},
    {"mkdir", call<mkdir>},
    {"sleep", call<sleep>},
    {"exists", call<[](const std::string& path) { return std::filesystem::exists(path); }>},
    {"is_link", call<[](const std::string& path) { return std::filesystem::is_symlink(path); }>},
    {"write_output", call<core_write_output>},
    {"write_file", call<write_record>}, // (file, bytes, durable = false): a file of the program's own
    {"read_file", call<read_file>},
    {"list_folder", call<list_folder>},
    {"hash", call<[](std::string_view bytes) { return fmt::format("{:016x}", checksum(bytes)); }>},
    {"lock", call<[](const std::string& file) { return Lock(file); }>}, // until :release()
    {"create_claim", call<create_claim>}, // (file, content): creates a file unless it exists; whether it did
    {"find_script", call<find_script>},   // the path of a supplied script, otherwise the name as it is
    {"release", call<release>},           // see library.hpp; lua/signorini/call/release.lua
    {"notice_given", call<notice_given>}, // whether Slurm has announced the end of this task
    {"set_threads", call<set_threads>},   // of the following solves; core.threads is the value of --threads
    {"describe", core_describe},
    {"nearest", call<core_nearest>},
    {"number_text", core_number_text},
    {"base64", call<base64>},
    {"kind", kind},
};

} // namespace

void open_core(lua_State* L) {
  register_type<Lock>(L, {{"release", collect<Lock>}}); // unlocks the file
  register_functions(L, "core", core_entries);
  register_functions(L, "sg", {{"mkdir", call<mkdir>}, {"wall_time", call<now>}});
}

} // namespace signorini::bind
