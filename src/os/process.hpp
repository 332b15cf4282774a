#pragma once
// External programs, run with a list of arguments: no shell is involved, so names need no quotes.

#include <string>
#include <vector>

namespace signorini {

/// True if a folder in PATH holds a program of this name.
bool has_program(const std::string& name);

/// Runs a program found in PATH, waits for it and returns its output, or the last 600 bytes of that. Throws Error with
/// the same text if it cannot be started or does not return status 0.
std::string run_program(const std::vector<std::string>& words);

} // namespace signorini
