#pragma once
// Execution of typed code by the prompt or a notebook.

#include "repl/chunk.hpp"
#include "repl/interpreter.hpp"

#include <string>

namespace signorini::repl {

struct Execution {
  bool ok = false;
  bool was_interrupted = false;
  std::string message; ///< if not ok; with the user's frames unless keep_traceback
};

/// A function of a module of the library.
struct LibraryFunction {
  const char *module, *name;
};

/// Runs the result of load() for this code, then a function with the values of an expression, whose results remain on
/// the stack. keep_traceback: as in Interpreter::call.
Execution execute(Interpreter& interpreter, Chunk chunk, const std::string& code, const LibraryFunction& results,
                  bool keep_traceback);

} // namespace signorini::repl
