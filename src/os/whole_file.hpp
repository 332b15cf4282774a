#pragma once
// Files that are written atomically.

#include "os/file_kind.hpp"

#include <string>
#include <string_view>

namespace signorini {

/// Throws Error if the name of a file contains a zero byte, at which the system would cut it off.
void check_file_name(const std::string& file);

/// Writes a file of the program's own, such as the record of a case: the bytes to a temporary file next to `file`,
/// which is then renamed; `durable`: they are on the disk before the old file is replaced. What a process that was
/// killed while writing has left is replaced by the next write of the same file. A link of this name is replaced, not
/// what it refers to. Throws Error if the folder does not exist or the file cannot be written.
void write_record(const std::string& file, std::string_view bytes, bool durable = false);

/// Writes a file that a user has named, in the same way. The target of a link is replaced, not the link; devices and
/// pipes are written to. Throws Error also if a file of another kind exists, which is kept.
void write_output(const std::string& file, std::string_view bytes, FileKind kind, bool durable = false);

/// The file that write_output() would replace, which is the target of a link. Throws Error if it may not.
std::string check_output(const std::string& file, FileKind kind);

/// Renames a complete file to what a user has named, on the same disk. Throws Error as write_output().
void move_output(const std::string& from, const std::string& file, FileKind kind);

/// Writes all bytes to an open file or pipe, also if signals interrupt it; false leaves the error in errno.
bool write_all(int handle, std::string_view bytes);

/// All bytes of a file. Throws Error if it cannot be read, also for a pipe in a folder, which may never end.
std::string read_file(const std::string& file);

} // namespace signorini
