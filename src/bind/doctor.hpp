#pragma once
// What the program is made of on this machine.

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace signorini::bind {

/// Names and versions of what results depend on: signorini, Lua, Eigen, SuiteSparse, BLAS, and the widest instructions
/// of the element kernels. An error where SIGNORINI_KERNEL names others than this machine has.
std::vector<std::pair<std::string, std::string>> versions();

/// `signorini --doctor`: writes these, and whether the program can draw; `readline` is that library's version. Returns
/// whether all is well.
bool doctor(std::ostream& out, int threads, const std::string& readline);

} // namespace signorini::bind
