#pragma once
// Files that are written atomically.

#include <string>
#include <string_view>

namespace signorini {

/// Throws Error if the name of a file contains a zero byte, at which the system would cut it off.
void check_file_name(const std::string& file);

/// Writes the bytes to a temporary file next to `file`, then renames it; `durable`: they are on the disk before the old
/// file is replaced. What a process that was killed while writing has left is replaced by the next write of the same
/// file. The target of a link is replaced, not the link; devices and pipes are written to. Throws Error if the folder
/// does not exist or the file cannot be written.
void write_atomically(const std::string& file, std::string_view bytes, bool durable = false);

/// Writes all bytes to an open file or pipe, also if signals interrupt it; false leaves the error in errno.
bool write_all(int handle, std::string_view bytes);

/// All bytes of a file. Throws Error if it cannot be read.
std::string read_file(const std::string& file);

} // namespace signorini
