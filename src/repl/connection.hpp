#pragma once
// Connection files, by which Jupyter tells a kernel where to listen.

#include "repl/kernel_module.hpp"

#include <string>

namespace signorini::repl {

/// Throws std::exception with a hint if the file cannot be read, is not valid JSON, or lacks an entry.
Connection read_connection(const std::string& file);

} // namespace signorini::repl
