#pragma once
// The prompt: lines with editing, history and completion on a terminal, plain lines otherwise.

#include "repl/interpreter.hpp"

namespace signorini::repl {

/// Reads, runs and prints until the input ends. Returns whether every line ran without error.
bool prompt(Interpreter& interpreter, bool quiet);

/// The version of the line-editing library.
const char* readline_version();

} // namespace signorini::repl
