#pragma once
// A file that one process at a time may hold, so that two do not write into the same folder.

#include <string>

namespace signorini {

/// Holds a file from its making to its end. The system lets go of it when the process ends, however that happens. A
/// child process holds it, too, as long as it lives.
class Lock {
public:
  /// Makes the file where there is none. Throws Error when it cannot be made, or when somebody holds it: then the
  /// message says who.
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
