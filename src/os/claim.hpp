#pragma once
// Claims: files that one process on one of several machines creates and all others find, on any shared disk.

#include <string>

namespace signorini {

/// Creates a file with this content unless it exists; returns whether it was created. Unlike a Lock it survives its
/// process, and works where locks of files are not seen by other machines. Throws Error if files cannot be written.
bool create_claim(const std::string& file, const std::string& content);

} // namespace signorini
