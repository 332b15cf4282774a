#pragma once
// External programs, run with a list of arguments: no shell is involved, so names need no quotes.

#include <string>
#include <vector>

namespace signorini {

/// Whether a folder in PATH holds a program of this name.
bool has_program(const std::string& name);

/// Runs a program found in PATH and waits for it. Throws Error with the end of its output if it cannot be started or
/// does not return status 0.
void run_program(const std::vector<std::string>& words);

} // namespace signorini
