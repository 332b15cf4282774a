#pragma once
// A Lua state with the complete language, which runs chunks and reports their errors.

#include "bind/program/library.hpp"

#include <memory>
#include <string>
#include <vector>

namespace signorini::repl {

class Interpreter {
public:
  explicit Interpreter(const bind::Settings& settings);

  lua_State* state() const { return state_.get(); }

  /// Sets the table `arg`: program, script and its arguments; also adds the script's folder to package.path.
  void set_arguments(const std::string& program, const std::string& script, const std::vector<std::string>& arguments);
  /// Makes `sg` and `help` global. Returns whether the library was loaded.
  bool open_globals();

  /// Each returns whether the chunk ran without error; errors go to standard error with a traceback. The result of a
  /// file is assigned to `_`, as at the prompt.
  bool run_code(const std::string& code, const std::string& name);
  bool run_file(const std::string& file, const std::vector<std::string>& arguments);

  /// True if a case of a study failed with an error (lua/signorini/study/execute.lua).
  bool lost_cases() const;

  /// Calls the function below `arguments` values on the stack: true with all its results on the stack, or false with
  /// the message and, unless keep_traceback, the user's frames of the traceback, which is stored in core.traceback.
  bool call(int arguments, bool keep_traceback = false);

private:
  bool report(bool ok);

  struct Close {
    void operator()(lua_State* L) const { lua_close(L); }
  };
  std::unique_ptr<lua_State, Close> state_;
  bool short_of_memory_ = false; ///< an allocation of Lua has failed
};

/// Adds the most frequent cause to a syntax error on the stack, if Lua's message does not state it.
void add_syntax_hint(lua_State* L);

} // namespace signorini::repl
