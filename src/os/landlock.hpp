#pragma once
// Landlock by its system calls: the C library has none, and Debian 12's header lacks what newer kernels offer.

#include <filesystem>

namespace signorini {

/// The version of the kernel's interface; 0 without Landlock.
int landlock_version();

/// The version from which on signals can be confined.
constexpr int landlock_confines_signals = 6;

/// Rules for this thread and those that it starts. What they do not allow is forbidden: every access to files, TCP,
/// signals to processes outside, abstract sockets, commands to devices, as far as the version covers them.
class Landlock {
public:
  /// Throws Error if the kernel refuses.
  explicit Landlock(int version);
  ~Landlock();
  Landlock(const Landlock&) = delete;
  Landlock& operator=(const Landlock&) = delete;

  /// Files and folders below the path can be read. A path that does not exist is ignored.
  void allow_reading(const std::filesystem::path& path);
  /// Files and folders below the path can be read, written, made, renamed and removed; but no links, devices, sockets
  /// or pipes are made, and nothing is executed.
  void allow_writing(const std::filesystem::path& path);
  /// Needs prctl(PR_SET_NO_NEW_PRIVS). Throws Error if the kernel refuses.
  void restrict() const;

private:
  void allow(const std::filesystem::path& path, unsigned long long access);

  unsigned long long handled_ = 0;
  int rules_ = -1;
};

} // namespace signorini
