#pragma once
// The versions of the program and of the libraries that results depend on.

#include <string>
#include <utility>
#include <vector>

namespace signorini::bind {

/// Names and versions: signorini, Lua, Eigen, SuiteSparse, BLAS, and the kernels' instructions.
std::vector<std::pair<std::string, std::string>> versions();

} // namespace signorini::bind
