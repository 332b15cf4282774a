#pragma once
// `signorini --doctor`: what the program is made of on this machine, and whether it can draw.

#include <iosfwd>
#include <string>

namespace signorini::bind {

/// Writes the report; `readline` is that library's version. Returns whether all is well.
bool doctor(std::ostream& out, int threads, const std::string& readline);

} // namespace signorini::bind
