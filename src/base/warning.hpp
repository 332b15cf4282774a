#pragma once
// What a user should know of a result that is there all the same.

#include <iostream>
#include <set>
#include <string>

namespace signorini {

/// Prints a line to the standard error, each message once. Inline, as the renderer's module does not link this room.
inline void warn(const std::string& message) {
  static std::set<std::string> said;
  if (said.insert(message).second) std::cerr << "signorini: warning: " << message << std::endl;
}

} // namespace signorini
