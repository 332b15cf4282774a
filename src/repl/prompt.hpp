#pragma once
// The prompt: line editing, history and completion on a terminal, plain lines otherwise.

#include "repl/interpreter.hpp"

namespace signorini::repl {

/// Reads, runs and prints until the end of input. Returns false when a line failed that was not typed at a terminal.
bool prompt(Interpreter& interpreter, bool quiet);

} // namespace signorini::repl
