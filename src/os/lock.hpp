#pragma once
// A lock file that one process at a time can hold, so that two do not write into the same folder.

#include <string>

namespace signorini {

/// Holds a lock file during its lifetime. The system releases it when the process ends for any reason. Child processes
/// hold it too, as long as they live.
class Lock {
public:
  /// Creates the file if there is none. Throws Error if it cannot be created, is a link or not a lock, or is locked;
  /// the message then names the holder.
  explicit Lock(const std::string& file);
  Lock(Lock&& other) noexcept;
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;
  Lock& operator=(Lock&&) = delete;
  ~Lock();

private:
  int handle_;
};

} // namespace signorini
