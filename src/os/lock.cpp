#include "os/lock.hpp"

#include "base/error.hpp"
#include "os/machine.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace signorini {

namespace {

constexpr std::string_view title = "process "; // of the text of a lock

/// Text that the holder has written to identify itself.
std::string holder(int handle) {
  char name[512];
  const ssize_t count = pread(handle, name, sizeof name, 0);
  return std::string(name, static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
}

/// Opens a lock's file, which is created if there is none; −1 leaves the reason in errno, EEXIST for another file, also
/// behind a link.
int open_lock(const std::string& file) {
  const int handle = open(file.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
  if (handle < 0) {
    if (errno == ELOOP || errno == ENXIO) errno = EEXIST;
    return handle;
  }
  struct stat about {};
  const std::string found = holder(handle);
  if (fstat(handle, &about) == 0 && S_ISREG(about.st_mode) && about.st_nlink <= 1 &&
      (found.empty() || found.starts_with(title)))
    return handle;
  close(handle);
  errno = EEXIST;
  return -1;
}

} // namespace

Lock::Lock(const std::string& file) : handle_(open_lock(file)) {
  require(handle_ >= 0 || errno != EEXIST, "os.lock.foreign", {{"file", file}});
  require(handle_ >= 0, "os.lock.write", {{"file", file}, {"reason", std::strerror(errno)}});
  // Children of a holder that was just killed take a moment to end.
  int reason = EWOULDBLOCK;
  for (int attempt = 0; attempt < 20 && (reason == EWOULDBLOCK || reason == EINTR); ++attempt) {
    if (attempt > 0) usleep(50'000);
    reason = flock(handle_, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
  }
  if (reason != 0) {
    std::string who = holder(handle_);
    if (who.empty()) who = "another process";
    close(handle_);
    require(reason == EWOULDBLOCK, "os.lock.lock", {{"file", file}, {"reason", std::strerror(reason)}});
    fail("os.lock.held", {{"file", file}, {"holder", who}});
  }
  // Writing the holder's name may fail: a full disk is not a reason to stop.
  const std::string self = text(title, getpid(), " on ", host_name());
  if (ftruncate(handle_, 0) != 0 || pwrite(handle_, self.data(), self.size(), 0) < 0) errno = 0;
}

Lock::Lock(Lock&& other) noexcept : handle_(std::exchange(other.handle_, -1)) {}

Lock::~Lock() {
  if (handle_ >= 0) close(handle_);
}

} // namespace signorini
