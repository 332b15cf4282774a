#include "bind/lua/coroutines.hpp"

#include "os/interrupt.hpp"

#include <atomic>

namespace signorini::bind {

namespace {

std::atomic<lua_State*> running = nullptr;
lua_CFunction lua_resume_function = nullptr, lua_wrapped_function = nullptr;

void pass_hook(lua_State* from, lua_State* to) {
  if (interrupted() && lua_gethook(from)) lua_sethook(to, lua_gethook(from), lua_gethookmask(from), 1);
}

/// Notes that a coroutine runs; at the end, also by an error, that its caller does.
class Run {
public:
  Run(lua_State* caller, lua_State* coroutine) : caller_(caller), coroutine_(coroutine) {
    running = coroutine;
    pass_hook(caller, coroutine);
  }
  ~Run() {
    running = caller_;
    pass_hook(coroutine_, caller_);
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

private:
  lua_State *caller_, *coroutine_;
};

int resume(lua_State* L) {
  lua_State* coroutine = lua_tothread(L, 1);
  if (!coroutine) return lua_resume_function(L);
  const Run run(L, coroutine);
  return lua_resume_function(L);
}

/// Has the coroutine as its upvalue, as Lua's own function does, which it calls.
int call_wrapped(lua_State* L) {
  const Run run(L, lua_tothread(L, lua_upvalueindex(1)));
  return lua_wrapped_function(L);
}

/// The upvalue is Lua's own coroutine.wrap.
int wrap_coroutine(lua_State* L) {
  luaL_checktype(L, 1, LUA_TFUNCTION);
  lua_settop(L, 1);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, 1, 1);
  lua_wrapped_function = lua_tocfunction(L, 1);
  lua_getupvalue(L, 1, 1);
  lua_pushcclosure(L, call_wrapped, 1);
  return 1;
}

} // namespace

void follow_coroutines(lua_State* L) {
  running = L;
  lua_getglobal(L, "coroutine");
  lua_getfield(L, -1, "resume");
  lua_resume_function = lua_tocfunction(L, -1);
  lua_pop(L, 1);
  lua_pushcfunction(L, resume);
  lua_setfield(L, -2, "resume");
  lua_getfield(L, -1, "wrap");
  lua_pushcclosure(L, wrap_coroutine, 1);
  lua_setfield(L, -2, "wrap");
  lua_pop(L, 1);
}

lua_State* running_thread() {
  return running;
}

} // namespace signorini::bind
