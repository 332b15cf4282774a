#include "os/file_identity.hpp"

#include <sys/stat.h>

namespace signorini {

std::optional<FileIdentity> identity_of(const std::string& file) {
  struct stat found = {};
  if (::stat(file.c_str(), &found) != 0) return {};
  return FileIdentity{found.st_dev, found.st_ino, found.st_mtim.tv_sec, found.st_mtim.tv_nsec};
}

} // namespace signorini
