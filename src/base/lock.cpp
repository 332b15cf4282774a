#include "base/lock.hpp"

#include "base/error.hpp"
#include "base/machine.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace signorini {

namespace {

/// Text that the holder has written to identify itself.
std::string holder(int handle) {
  char name[512];
  const ssize_t count = pread(handle, name, sizeof name, 0);
  return count > 0 ? std::string(name, static_cast<std::size_t>(count)) : "another process";
}

} // namespace

Lock::Lock(const std::string& file) : handle_(open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  require(handle_ >= 0, "base.lock.write", {{"file", file}, {"reason", std::strerror(errno)}});
  // Children of a holder that was just killed take a moment to end.
  int reason = EWOULDBLOCK;
  for (int attempt = 0; attempt < 20 && (reason == EWOULDBLOCK || reason == EINTR); ++attempt) {
    if (attempt > 0) usleep(50'000);
    reason = flock(handle_, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
  }
  if (reason != 0) {
    const std::string who = holder(handle_);
    close(handle_);
    require(reason == EWOULDBLOCK, "base.lock.lock", {{"file", file}, {"reason", std::strerror(reason)}});
    fail("base.lock.held", {{"file", file}, {"holder", who}});
  }
  // Writing the holder's name may fail: a full disk is not a reason to stop.
  const std::string self = text("process ", getpid(), " on ", host_name());
  if (ftruncate(handle_, 0) != 0 || pwrite(handle_, self.data(), self.size(), 0) < 0) errno = 0;
}

Lock::Lock(Lock&& other) noexcept : handle_(std::exchange(other.handle_, -1)) {}

Lock::~Lock() {
  if (handle_ >= 0) close(handle_);
}

} // namespace signorini
