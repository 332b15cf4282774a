#include "os/claim.hpp"

#include "base/error.hpp"
#include "os/machine.hpp"
#include "os/whole_file.hpp"

#include <cerrno>
#include <cstring>
#include <sys/stat.h>
#include <unistd.h>

namespace signorini {

bool create_claim(const std::string& file, const std::string& content) {
  // link() is atomic on every file system, also between clients of NFS, and fails if the name exists (open(2), O_EXCL).
  // The content is complete before the name appears. Processes of two machines may have the same number.
  const std::string own = text(file, ".", host_name(), ".", getpid());
  write_record(own, content, true);
  const int failure = link(own.c_str(), file.c_str()) == 0 ? 0 : errno;
  // A reply of the server may be lost and the repeated request fail: the number of links tells what happened.
  struct stat status {};
  const bool created = failure == 0 || (stat(own.c_str(), &status) == 0 && status.st_nlink == 2);
  unlink(own.c_str());
  require(created || failure == EEXIST, "os.claim.link", {{"file", file}, {"reason", std::strerror(failure)}});
  return created;
}

} // namespace signorini
