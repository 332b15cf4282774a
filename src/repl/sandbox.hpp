#pragma once
// --sandbox, --memory and --time of the command line, applied before Lua starts.

#include "repl/command_line.hpp"

namespace signorini::repl {

/// Applies --memory, and enters the sandbox of --sandbox, in which limits that are not given have defaults. The
/// environment is replaced by that of the sandbox, for which the process executes the program again with the same
/// arguments: secrets in it would remain readable otherwise. The line then holds the limits, the folder in full, and
/// the script's name as seen from this folder. Before threads start; throws Error.
void apply_limits(CommandLine& line, char** arguments);

} // namespace signorini::repl
