#pragma once
// Versions and capabilities of the program on this machine.

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace signorini::bind {

/// Names and versions of libraries that affect results: signorini, Lua, Eigen, SuiteSparse, BLAS, and the instruction
/// set of the element kernels. Throws Error when SIGNORINI_KERNEL names an instruction set that this machine lacks.
std::vector<std::pair<std::string, std::string>> versions();

/// `signorini --doctor`: prints these, and whether the program can draw; `readline`: version of that library. Returns
/// whether everything works.
bool doctor(std::ostream& out, int threads, const std::string& readline);

} // namespace signorini::bind
