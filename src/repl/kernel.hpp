#pragma once
// The Jupyter kernel: this program as the language of notebooks.

#include "repl/interpreter.hpp"

#include <string>

namespace signorini::repl {

/// Makes requests of front ends the input of the interpreter, whose globals are not open yet, until one of them ends
/// the process. `code` of -e is run first. Throws std::exception if the file or its ports cannot be used.
[[noreturn]] void serve_kernel(Interpreter& interpreter, const std::string& connection_file,
                               const std::vector<std::string>& code);

/// Throws std::exception unless the kernel is installed; `option`: of the command line, for the message.
void require_kernel(const char* option);

/// The libraries of the kernel, or that it is not installed.
std::string kernel_description();

} // namespace signorini::repl
