#pragma once
// The prompt: lines with editing, history and completion on a terminal, plain lines otherwise.

#include "repl/interpreter.hpp"

namespace signorini::repl {

/// Reads, runs and prints until the input ends. Returns false when a line failed that was not typed on a terminal.
bool prompt(Interpreter& interpreter, bool quiet);

} // namespace signorini::repl
