#pragma once
// Checks if a file is still the one that was seen before.

#include <cstdint>
#include <optional>
#include <string>

namespace signorini {

/// A file as its file system knows it: another file of the same name differs, also one with the same contents.
struct FileIdentity {
  std::uint64_t device, number;
  std::int64_t seconds, nanoseconds; ///< of its last change
  bool operator==(const FileIdentity&) const = default;
};

/// Empty if there is no such file.
std::optional<FileIdentity> identity_of(const std::string& file);

} // namespace signorini
