#include "repl/kernel.hpp"

#include "bind/lua/arguments.hpp"
#include "bind/lua/functions.hpp"
#include "os/interrupt.hpp"
#include "os/module.hpp"
#include "repl/connection.hpp"
#include "repl/execution.hpp"
#include "repl/interrupt.hpp"

#include <csignal>
#include <pthread.h>

namespace signorini::repl {

namespace {

constexpr const char* kernel_file = "signorini_kernel.so";

const KernelModule& load_kernel(const char* option) {
  const std::filesystem::path file = find_module(kernel_file);
  const auto [first, second] = module_folders();
  if (file.empty())
    bind::fail(option, " is not available: ", kernel_file, " is neither in ", first.string(), " nor in ",
               second.string(), ". Hint: install the Debian package signorini-jupyter, or xeus-dev before the build");
  return *static_cast<const KernelModule*>(load_module(file, "signorini_kernel"));
}

/// During its lifetime Ctrl-C reaches this thread, otherwise it waits: neither sockets nor other threads of the kernel
/// see it.
class AcceptsInterrupts {
public:
  explicit AcceptsInterrupts(lua_State* L) : L_(L) {
    set(SIG_UNBLOCK);
    forget_interrupt(L_); // one that came between two cells
  }
  ~AcceptsInterrupts() {
    set(SIG_BLOCK);
    forget_interrupt(L_);
  }
  AcceptsInterrupts(const AcceptsInterrupts&) = delete;
  AcceptsInterrupts& operator=(const AcceptsInterrupts&) = delete;

  static void set(int how) {
    sigset_t interrupt;
    sigemptyset(&interrupt);
    sigaddset(&interrupt, SIGINT);
    pthread_sigmask(how, &interrupt, nullptr);
  }

private:
  lua_State* L_;
};

// ── What Lua asks of the front end (lua/signorini/prompt/kernel.lua)
// ────────────────────────────────────────────────────────

FrontEnd& front_end(lua_State* L) {
  return *static_cast<FrontEnd*>(lua_touserdata(L, lua_upvalueindex(2)));
}

/// Formats by MIME type, { ["text/plain"] = … }, with width and height of images.
Display read_display(lua_State* L, int index) {
  Display display;
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
    std::size_t size = 0;
    const char* bytes = lua_type(L, -1) == LUA_TSTRING ? lua_tolstring(L, -1, &size) : nullptr;
    if (bytes) display.formats.emplace_back(lua_tostring(L, -2), std::string(bytes, size));
  }
  lua_getfield(L, index, "width");
  lua_getfield(L, index, "height");
  display.width = static_cast<int>(lua_tointeger(L, -2));
  display.height = static_cast<int>(lua_tointeger(L, -1));
  lua_pop(L, 2);
  return display;
}

int show(lua_State* L) {
  front_end(L).show(read_display(L, 1));
  return 0;
}

int replace(lua_State* L) {
  front_end(L).replace(lua_tostring(L, 1), lua_tostring(L, 2));
  return 0;
}

int read_line(lua_State* L) {
  bind::push(L, front_end(L).read_line());
  return 1;
}

/// core.front_end, whose functions the library calls.
void offer(lua_State* L, FrontEnd& front_end) {
  struct Row {
    const char *key, *name; ///< the name is that in messages
    lua_CFunction function;
  };
  constexpr Row rows[] = {{"show", "picture", bind::wrap<show>},
                          {"replace", "progress", bind::wrap<replace>},
                          {"read_line", "io.read", bind::wrap<read_line>}};
  bind::push_table(L, "core.front_end");
  for (const auto& [key, name, function] : rows) {
    bind::push(L, name);
    lua_pushlightuserdata(L, &front_end);
    lua_pushcclosure(L, function, 2);
    lua_setfield(L, -2, key);
  }
  lua_pop(L, 1);
}

// ── What the front end asks ──────────────────────────────────────────────────────────────────────────────────────────

constexpr const char* no_exit =
    "exit is not available in a notebook. Hint: shut down or restart the kernel in the menu of the front end";

/// The message in red, then the frames, if there are others than the cell itself.
Failure failure_of(const Execution& execution) {
  const std::string divider = "\nstack traceback:\n", red = "\33[31m", plain = "\33[0m";
  const auto end = execution.was_interrupted ? std::string::npos : execution.message.rfind(divider);
  const std::string message = execution.message.substr(0, end);
  const std::string frames = end == std::string::npos ? "" : execution.message.substr(end + divider.size());
  const bool has_frames = frames.find('\n') != std::string::npos;
  return {execution.was_interrupted ? "interrupted" : "error", message,
          red + message + plain + (has_frames ? divider + frames : "")};
}

class Cells final : public Evaluator {
public:
  Cells(Interpreter& interpreter, FrontEnd& front_end) : interpreter_(interpreter), main_(pthread_self()) {
    offer(interpreter.state(), front_end);
    call(
        "open", [] {}, 0);
  }

  Outcome execute(const std::string& code, int number) override {
    return outcome_of(code, text("cell ", number), "results");
  }

  Outcome evaluate(const std::string& expression) override {
    return outcome_of(expression, "user expression", "value");
  }

  Completions complete(const std::string& code, int cursor) override {
    lua_State* L = interpreter_.state();
    Completions found;
    if (!call(
            "complete", [&] { push_place(code, cursor); }, 2))
      return found;
    found.matches = bind::to<std::vector<std::string>>(L, 1);
    found.begin = static_cast<int>(lua_tointeger(L, 2));
    found.end = static_cast<int>(lua_tointeger(L, 3));
    return found;
  }

  Display inspect(const std::string& code, int cursor) override {
    const bool found = call(
                           "inspect", [&] { push_place(code, cursor); }, 2) &&
                       lua_istable(interpreter_.state(), 1);
    return found ? read_display(interpreter_.state(), 1) : Display{};
  }

  std::pair<Completeness, std::string> test(const std::string& code) override {
    lua_State* L = interpreter_.state();
    if (code.find_first_not_of(" \t\n") == std::string::npos) return {Completeness::complete, ""};
    const Chunk chunk = load_cell(L, code, "cell");
    if (chunk == Chunk::unfinished) {
      const bool ok = call(
          "indent", [&] { bind::push(L, code); }, 1);
      return {Completeness::incomplete, ok ? lua_tostring(L, 1) : ""};
    }
    return {lua_isfunction(L, 1) ? Completeness::complete : Completeness::invalid, ""};
  }

  void interrupt() override { pthread_kill(main_, SIGINT); }
  bool interrupted() const override { return signorini::interrupted(); }
  std::string version() const override { return SIGNORINI_VERSION; }
  std::string language_version() const override {
    return LUA_VERSION_MAJOR "." LUA_VERSION_MINOR "." LUA_VERSION_RELEASE;
  }

private:
  Outcome outcome_of(const std::string& code, const std::string& name, const char* results) {
    lua_State* L = interpreter_.state();
    const AcceptsInterrupts scope(L);
    if (code.find_first_not_of(" \t\n") == std::string::npos) return {};
    if (asks_to_leave(L, code)) return {failure_of({.message = no_exit}), {}};
    const Execution execution = signorini::repl::execute(interpreter_, load_cell(L, code, name), code,
                                                         {"signorini.prompt.kernel", results}, false);
    Outcome outcome;
    if (!execution.ok)
      outcome.failure = failure_of(execution);
    else if (lua_istable(L, 1))
      outcome.value = read_display(L, 1);
    lua_settop(L, 0);
    return outcome;
  }

  void push_place(const std::string& code, int cursor) {
    bind::push(interpreter_.state(), code);
    bind::push(interpreter_.state(), cursor);
  }

  /// Calls a function of signorini.kernel, whose results are then the only stack entries; false after an error.
  template <class PushArguments> bool call(const char* function, PushArguments push_arguments, int count) {
    lua_State* L = interpreter_.state();
    lua_settop(L, 0);
    push_library_function(L, "signorini.prompt.kernel", function);
    push_arguments();
    return interpreter_.call(count, true);
  }

  Interpreter& interpreter_;
  const pthread_t main_;
};

} // namespace

void serve_kernel(Interpreter& interpreter, const std::string& connection_file, const std::vector<std::string>& code) {
  const KernelModule& module = load_kernel("--kernel");
  const Connection connection = read_connection(connection_file);
  survive_interrupts();
  finish_statements();
  AcceptsInterrupts::set(SIG_BLOCK);
  const auto make = [&](FrontEnd& front_end) {
    bool ok = interpreter.open_globals(); // first: %who lists what differs from the global names that it leaves
    auto cells = std::make_unique<Cells>(interpreter, front_end);
    for (const auto& each : code) ok = ok && interpreter.run_code(each, "=(command line)");
    if (!ok) bind::fail("--kernel: the kernel ends, because the code before its first cell failed");
    return cells;
  };
  const std::string reason = module.serve(connection, make);
  bind::fail("--kernel: cannot listen at the ports of '", connection_file, "': ", reason,
             ". Hint: another kernel may use this file; Jupyter writes one for each");
}

void require_kernel(const char* option) {
  load_kernel(option);
}

std::string kernel_description() {
  if (find_module(kernel_file).empty()) return "not installed, --kernel is not available";
  return load_kernel("--kernel").description();
}

} // namespace signorini::repl
