#pragma once
// Queries to the terminal on standard input and output.

#include "terminal/answers.hpp"

#include <functional>
#include <string>

namespace signorini::terminal {

/// True if queries can be answered and read: standard input and output are terminals, and this process, not one forked
/// from it, reads keys there.
bool can_ask();

/// Writes queries, waits until the terminal has answered the device attributes as well, at most two seconds or until
/// Ctrl-C, and adds its answers. Needs can_ask().
void ask(const std::string& queries, Answers& answers);

/// Receives keys that were typed before the answers. By default they go back to C's standard input.
void keep_typed(std::function<void(const std::string&)> keep);

/// Writes to standard output, after what was written there before.
void put(const std::string& bytes);

} // namespace signorini::terminal
