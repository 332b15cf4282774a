#include "view/parts_folder.hpp"

#include "base/error.hpp"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace signorini::view {

namespace fs = std::filesystem;

PartsFolder::PartsFolder(const std::string& file) {
  const fs::path path = fs::absolute(file), place = path.parent_path();
  const std::string stem = (place / ("." + path.filename().string())).string();
  folder_ = stem + ".parts";
  if (take()) return;
  folder_ = stem + ".XXXXXX";
  require(::mkdtemp(folder_.data()) != nullptr, "view.series.folder", {{"file", file}});
}

PartsFolder::~PartsFolder() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  if (handle_ >= 0) ::close(handle_);
}

/// Creates and locks the folder, and empties it; false if another process holds it, or removed it in the meantime.
bool PartsFolder::take() {
  if (::mkdir(folder_.c_str(), 0777) != 0 && errno != EEXIST) return false;
  handle_ = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  struct stat opened, there;
  std::error_code error;
  if (handle_ >= 0 && ::flock(handle_, LOCK_EX | LOCK_NB) == 0 && ::fstat(handle_, &opened) == 0 &&
      ::lstat(folder_.c_str(), &there) == 0 && opened.st_dev == there.st_dev && opened.st_ino == there.st_ino) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) fs::remove_all(entry, error);
    if (!error) return true;
  }
  if (handle_ >= 0) ::close(handle_);
  handle_ = -1;
  return false;
}

} // namespace signorini::view
