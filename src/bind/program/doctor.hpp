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

/// A library of a module right of this one, and a function that describes it.
struct OtherLibrary {
  const char* name;
  std::string (*description)();
};

/// `signorini --doctor`: prints these, other libraries, and whether the program can draw. Returns whether everything
/// works.
bool doctor(std::ostream& out, int threads, const std::vector<OtherLibrary>& others);

} // namespace signorini::bind
