#pragma once
// Messages about a result that is valid but may not be what the user wants.

#include "base/message.hpp"

#include <iostream>

namespace signorini {

/// Receives warnings: bind words and prints them. A module that is loaded later has a sink of its own.
using WarningSink = void (*)(const Message& warning);
inline WarningSink warning_sink = [](const Message& warning) { std::cerr << bare_text(warning) << std::endl; };

inline void warn(const char* code, std::initializer_list<Datum> data = {}) {
  warning_sink(Message(code, data));
}

} // namespace signorini
