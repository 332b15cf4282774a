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

/// Temporary files of a file `name` are called .name.<process number>.part.
constexpr std::string_view ending = ".part";

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : ".";
}

/// The file to which a temporary file belongs whose process no longer exists; empty for other files.
std::string_view left_by(std::string_view name) {
  if (!name.starts_with('.') || !name.ends_with(ending)) return {};
  const std::string_view stem = name.substr(0, name.size() - ending.size());
  const std::size_t dot = stem.rfind('.');
  if (dot == 0) return {};
  int process = 0;
  const auto [end, error] = std::from_chars(stem.data() + dot + 1, stem.data() + stem.size(), process);
  if (error != std::errc() || end != stem.data() + stem.size() || process <= 0) return {};
  return ::kill(process, 0) != 0 && errno == ESRCH ? stem.substr(1, dot - 1) : std::string_view();
}

/// Calls visit(path, file) for each such temporary file in a folder.
template <class Visit> void each_leftover(const fs::path& folder, const Visit& visit) {
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end; entry.increment(ignored)) {
    const std::string name = entry->path().filename().string();
    if (const std::string_view file = left_by(name); !file.empty()) visit(entry->path(), file);
  }
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

void check_file_name(const std::string& file) {
  require(file.find('\0') == std::string::npos, "base.file.zero", {{"file", file}});
}

void write_atomically(const std::string& file, std::string_view bytes, bool durable) {
  check_file_name(file);
  require(fs::path(file).has_filename(), "base.file.no_name", {{"file", file}});
  std::error_code ignored;
  if (fs::is_other(file, ignored)) return write_into(file, bytes);
  const fs::path path = target_of(file), folder = folder_of(path);
  check_folder(file, folder);
  require(!fs::is_directory(path, ignored), "base.file.write_folder", {{"file", file}});

  const std::string name = (folder / text(".", path.filename().string(), ".", ::getpid(), ending)).string();
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
  const std::string name = path.filename().string();
  each_leftover(folder_of(path), [&](const fs::path& temporary, std::string_view of) {
    std::error_code ignored;
    if (of == name) fs::remove(temporary, ignored);
  });
}

std::vector<std::string> files_with_leftovers(const std::string& folder) {
  std::vector<std::string> files;
  each_leftover(folder, [&](const fs::path&, std::string_view file) { files.emplace_back(file); });
  return files;
}

std::string read_file(const std::string& file) {
  check_file_name(file);
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
