#pragma once
// Files that are written whole or not at all.

#include <string>
#include <string_view>

namespace signorini {

/// Puts the bytes into a temporary file next to `file`, then renames it; `durable`: they are on the disk before the old
/// file goes. Of a link the target is replaced; into a device or a pipe the bytes are written. Throws Error when the
/// folder does not exist or the file cannot be written.
void write_whole(const std::string& file, std::string_view bytes, bool durable = false);

/// Writes all bytes to an open file or pipe, whatever signals come in between; false leaves the error in errno.
bool write_all(int handle, std::string_view bytes);

/// Removes temporary files of this name that processes left which were killed while they wrote.
void remove_leftovers(const std::string& file);

/// All bytes of a file. Throws Error when it cannot be read.
std::string read_whole(const std::string& file);

} // namespace signorini
