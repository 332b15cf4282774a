#pragma once
// Other programs, run with a list of arguments: no shell reads it, so no name needs quotes.

#include <string>
#include <vector>

namespace signorini {

/// Whether one of the folders in PATH holds a program of this name.
bool has_program(const std::string& name);

/// Runs a program, found in PATH, to its end. Throws Error with the end of what it wrote when it cannot be started or
/// does not end with status 0.
void run_program(const std::vector<std::string>& words);

} // namespace signorini
