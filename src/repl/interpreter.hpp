#pragma once
// A Lua state with the whole language, and chunks run in it with their errors reported.

#include "bind/library.hpp"

#include <memory>
#include <string>
#include <vector>

namespace signorini::repl {

class Interpreter {
public:
  explicit Interpreter(const bind::Settings& settings);

  lua_State* state() const { return state_.get(); }

  /// The table `arg`: program, script and its arguments; also puts the script's folder on package.path.
  void set_arguments(const std::string& program, const std::string& script, const std::vector<std::string>& arguments);
  /// Makes `sg` and `help` global. Returns whether the library could be loaded.
  bool open_globals();

  /// Each returns whether the chunk ran without error; an error goes to standard error with a traceback. What a file
  /// returns is `_` from then on, as a result at the prompt is.
  bool run_code(const std::string& code, const std::string& name);
  bool run_file(const std::string& file, const std::vector<std::string>& arguments);

  /// Whether a case of a study ended by an error (lua/signorini/study/execute.lua), so that not all went well.
  bool lost_cases() const;

  /// Calls the function below `arguments` values on the stack: true with all its results on the stack, or false with
  /// the message and the traceback, which goes to core.traceback instead when it is to be kept for later.
  bool call(int arguments, bool keep_traceback = false);

private:
  bool report(bool ok);

  struct Close {
    void operator()(lua_State* L) const { lua_close(L); }
  };
  std::unique_ptr<lua_State, Close> state_;
};

/// Adds to a syntax error on the stack what is most often behind it, where Lua's own words do not say so.
void add_syntax_hint(lua_State* L);

} // namespace signorini::repl
