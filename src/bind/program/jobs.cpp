#include "os/jobs.hpp"
#include "bind/lua/arguments.hpp"
#include "bind/lua/functions.hpp"
#include "bind/lua/limits.hpp"
#include "bind/lua/open.hpp"
#include "bind/lua/threads.hpp"
#include "bind/lua/wording/wording.hpp"

namespace signorini::bind {

namespace {

int add_traceback(lua_State* L) {
  push_error_text(L, 1);
  luaL_traceback(L, L, lua_tostring(L, -1), 1);
  return 1;
}

/// The result of the function at `index` for a job, in the child process: one thread for all libraries, no progress
/// display.
std::string call_job(lua_State* L, int index, int job) {
  set_threads(1);
  push_table(L, "core");
  set_fields(L, "quiet", true, "at_once", 1);
  lua_pushcfunction(L, add_traceback);
  lua_pushvalue(L, index);
  push(L, job + 1);
  const int status = lua_pcall(L, 1, 1, -3);
  if (status == LUA_ERRMEM) throw std::runtime_error(missing_lua_memory());
  require(lua_type(L, -1) == LUA_TSTRING, "the function of a job must return a string, got ", describe(L, -1));
  std::size_t size;
  const char* result = lua_tolstring(L, -1, &size);
  if (status != LUA_OK) throw std::runtime_error(result);
  return {result, size};
}

/// core.jobs(count, at_once, run, done, limit, look, grace): calls run(i) for i = 1 … count, each in its own child
/// process, at most at_once in parallel, and in this process done(i, text, failure) as each ends, in order of
/// completion. run must return a string, which is passed as text; otherwise text is nil and failure is "time" (longer
/// than limit seconds), "terminated by signal 11", "failed: <message and traceback>", "exited with status 3 …" or
/// "stopped" (after a notice: at a checkpoint, or grace seconds later). A child has one thread and no progress display,
/// and its changes are lost. look(running) is called about ten times per second. Returns false after Ctrl-C or a
/// notice; completed jobs are kept.
int jobs(lua_State* L) {
  lua_settop(L, 7);
  JobLimits limits{.at_once = to<int>(L, 2)};
  if (!lua_isnil(L, 5)) limits.seconds = to<double>(L, 5);
  if (!lua_isnil(L, 7)) limits.grace = to<double>(L, 7);
  const bool whole = run_jobs(
      to<int>(L, 1), limits, [L](int job) { return call_job(L, 3, job); },
      [L](const JobEnd& end) {
        lua_pushvalue(L, 4);
        push(L, end.job + 1);
        const bool well = end.failure.code.empty();
        well ? push(L, end.output) : lua_pushnil(L);
        well ? lua_pushnil(L) : push(L, worded(end.failure));
        lua_call(L, 3, 0);
      },
      [L](int running) {
        if (lua_isnil(L, 6)) return;
        lua_pushvalue(L, 6);
        push(L, running);
        lua_call(L, 1, 0);
      });
  push(L, whole);
  return 1;
}

} // namespace

void open_jobs(lua_State* L) {
  register_functions(L, "core", {{"jobs", jobs}});
}

} // namespace signorini::bind
