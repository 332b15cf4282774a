#include "view/output.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>
#include <utility>

namespace signorini::view {
namespace {

/// Removes the temporary file unless it has become the real one.
struct Temporary {
  std::string path;
  int handle;
  bool kept = false;

  ~Temporary() {
    if (handle >= 0) ::close(handle);
    if (!kept) ::unlink(path.c_str());
  }
};

[[noreturn]] void cannot_write(const std::string& file, int error) {
  fail("cannot write '", file, "': ", std::strerror(error),
       "; choose a file in a folder that you may write to, with space left");
}

void write_all(int handle, std::string_view bytes, const std::string& file) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(handle, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) cannot_write(file, errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

} // namespace

void write_whole(const std::string& file, std::string_view bytes) {
  const std::filesystem::path path(file);
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  std::error_code ignored;
  require(path.has_filename(), "file '", file, "' names a folder; add the name of a file");
  require(std::filesystem::is_directory(folder, ignored), "cannot write '", file, "': the folder '", folder.string(),
          "' does not exist; create it first");
  require(!std::filesystem::is_directory(path, ignored), "cannot write '", file,
          "': it is a folder; add the name of a file");

  const std::string name = (folder / text(".", path.filename().string(), ".", ::getpid(), ".part")).string();
  Temporary temporary{name, ::open(name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)};
  if (temporary.handle < 0) cannot_write(file, errno);
  write_all(temporary.handle, bytes, file);
  // Some file systems report a full disk only here.
  const int closed = ::close(std::exchange(temporary.handle, -1));
  if (closed != 0 || ::rename(name.c_str(), file.c_str()) != 0) cannot_write(file, errno);
  temporary.kept = true;
}

std::string file_ending(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

} // namespace signorini::view
