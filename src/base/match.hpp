#pragma once
// Regular expressions by the C library: <regex> takes the compiler four seconds in every unit that includes it.

#include <string>
#include <vector>

namespace signorini {

/// What the groups of a POSIX extended regular expression stand for in a text that matches it as a whole, the whole
/// text first, "" for groups that take no part. Empty where the text does not match.
std::vector<std::string> match(const std::string& text, const char* expression);

} // namespace signorini
