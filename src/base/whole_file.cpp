#include "base/whole_file.hpp"

#include "base/error.hpp"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>
#include <utility>

namespace signorini {

namespace fs = std::filesystem;

namespace {

/// Removes the temporary file unless it was renamed.
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
  fail("base.file.write", {{"file", file}, {"reason", std::strerror(error)}});
}

constexpr std::string_view ending = ".part";

/// First part of the names of temporary files of `path`; process number and extension follow.
std::string temporary_stem(const fs::path& path) {
  return text(".", path.filename().string(), ".");
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : ".";
}

/// The process that wrote a temporary file with this stem; 0 for other files.
int owner(std::string_view name, std::string_view stem) {
  if (!name.starts_with(stem) || !name.ends_with(ending) || name.size() <= stem.size() + ending.size()) return 0;
  const std::string_view digits = name.substr(stem.size(), name.size() - stem.size() - ending.size());
  int process = 0;
  const auto [end, error] = std::from_chars(digits.begin(), digits.end(), process);
  return error == std::errc() && end == digits.end() ? process : 0;
}

/// Throws Error unless the file's folder exists; the message says what is in its place or how to create it.
void check_folder(const std::string& file, const fs::path& folder) {
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) return;
  fs::path above = folder;
  while (above.has_parent_path() && above != above.parent_path() && !fs::exists(above, ignored))
    above = above.parent_path();
  require(!fs::exists(above, ignored) || fs::is_directory(above, ignored), "base.file.in_a_file",
          {{"file", file}, {"above", above.string()}});
  require(*folder.begin() != "~", "base.file.tilde", {{"file", file}});
  fail("base.file.no_folder", {{"file", file}, {"folder", folder.string()}});
}

/// The target of a link, which may not exist yet; follows at most 40 links, as the system does.
fs::path target_of(fs::path path) {
  std::error_code ignored;
  for (int i = 0; i < 40 && fs::is_symlink(path, ignored); ++i)
    path = path.parent_path() / fs::read_symlink(path, ignored);
  return path;
}

/// Writes to a device or a pipe, such as /dev/null or /dev/stdout, which a rename would replace by a file.
void write_into(const std::string& file, std::string_view bytes) {
  const int handle = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  const bool written = handle >= 0 && write_all(handle, bytes);
  const int error = errno;
  if (handle >= 0) ::close(handle);
  if (!written) cannot_write(file, error);
}

} // namespace

bool write_all(int handle, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(handle, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

void write_atomically(const std::string& file, std::string_view bytes, bool durable) {
  require(fs::path(file).has_filename(), "base.file.no_name", {{"file", file}});
  std::error_code ignored;
  if (fs::is_other(file, ignored)) return write_into(file, bytes);
  const fs::path path = target_of(file), folder = folder_of(path);
  check_folder(file, folder);
  require(!fs::is_directory(path, ignored), "base.file.write_folder", {{"file", file}});

  const std::string name = (folder / text(temporary_stem(path), ::getpid(), ending)).string();
  Temporary temporary{name, ::open(name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)};
  if (temporary.handle < 0 || !write_all(temporary.handle, bytes)) cannot_write(file, errno);
  if (durable && ::fsync(temporary.handle) != 0) cannot_write(file, errno);
  // Some file systems report a full disk only on closing.
  const int closed = ::close(std::exchange(temporary.handle, -1));
  if (closed != 0 || ::rename(name.c_str(), path.c_str()) != 0) cannot_write(file, errno);
  temporary.kept = true;
}

void remove_leftovers(const std::string& file) {
  const fs::path path(file);
  const std::string stem = temporary_stem(path);
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder_of(path), ignored))
    if (const int process = owner(entry.path().filename().string(), stem);
        process > 0 && ::kill(process, 0) != 0 && errno == ESRCH)
      fs::remove(entry.path(), ignored);
}

std::string read_file(const std::string& file) {
  std::error_code ignored;
  require(!fs::is_directory(file, ignored), "base.file.read_folder", {{"file", file}});
  std::ifstream in(file, std::ios::binary);
  require(in.good(), "base.file.read", {{"file", file}, {"reason", std::strerror(errno)}});
  std::ostringstream out;
  out << in.rdbuf();
  require(!in.bad(), "base.file.read_broken", {{"file", file}, {"reason", std::strerror(errno)}});
  return std::move(out).str();
}

} // namespace signorini
