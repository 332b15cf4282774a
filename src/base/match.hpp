#pragma once
// Regular expressions by the C library: <regex> adds four seconds of compile time to every unit that includes it.

#include <string>
#include <vector>

namespace signorini {

/// Groups of a POSIX extended regular expression that matches the whole text: the whole text first, "" for groups that
/// do not take part. Empty if the text does not match.
std::vector<std::string> match(const std::string& text, const char* expression);

} // namespace signorini
