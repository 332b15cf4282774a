#include "os/whole_file.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace signorini {

namespace fs = std::filesystem;

namespace {

/// An open file, which is removed unless it was renamed.
struct Temporary {
  std::string path;
  int handle;
  bool kept = false;

  ~Temporary() {
    if (!kept) ::unlink(path.c_str());
    if (handle >= 0) ::close(handle);
  }
};

[[noreturn]] void cannot_write(const std::string& file, int error) {
  if (rlimit most{}; error == EFBIG && ::getrlimit(RLIMIT_FSIZE, &most) == 0 && most.rlim_cur != RLIM_INFINITY)
    fail("os.file.too_large", {{"file", file}, {"most", most.rlim_cur}});
  fail("os.file.write", {{"file", file}, {"reason", std::strerror(error)}});
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : ".";
}

/// Locks an open file for as long as it is open; false if another process has locked it, or has renamed or removed it
/// since it was opened. The lock ends with the process, and counts on all machines that see the folder. It is none of
/// flock(), by which readers of HDF5 lock the renamed file.
bool take(int handle, const std::string& name) {
  struct flock whole {};
  whole.l_type = F_WRLCK;
  if (::fcntl(handle, F_OFD_SETLK, &whole) != 0) {
    if (errno != EAGAIN && errno != EACCES) ::unlink(name.c_str()); // files cannot be locked here: nobody holds it
    return false;
  }
  struct stat opened, there;
  return ::fstat(handle, &opened) == 0 && ::lstat(name.c_str(), &there) == 0 && opened.st_dev == there.st_dev &&
         opened.st_ino == there.st_ino && opened.st_nlink == 1 && S_ISREG(opened.st_mode);
}

/// The empty temporary file for a file: .name.part, so that the next process overwrites what a killed one has left;
/// while another process writes that, or where files cannot be locked, .name.<process number>.part.
Temporary temporary_for(const fs::path& path) {
  const auto name = [&](const std::string& owner) {
    return (folder_of(path) / text(".", path.filename().string(), owner, ".part")).string();
  };
  const std::string common = name("");
  const int handle = ::open(common.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (handle >= 0) {
    if (take(handle, common) && ::ftruncate(handle, 0) == 0) return {common, handle};
    ::close(handle);
  }
  const std::string own = name(text(".", ::getpid()));
  return {own, ::open(own.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)};
}

/// Some file systems report a full disk only on closing. Closing a duplicate makes them report, and keeps the lock.
bool is_complete(int handle) {
  const int same = ::dup(handle);
  return same >= 0 && ::close(same) == 0;
}

/// Throws Error unless the file's folder exists; the message says what is in its place or how to create it.
void check_folder(const std::string& file, const fs::path& folder) {
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) return;
  fs::path above = folder;
  while (above.has_parent_path() && above != above.parent_path() && !fs::exists(above, ignored))
    above = above.parent_path();
  require(!fs::exists(above, ignored) || fs::is_directory(above, ignored), "os.file.in_a_file",
          {{"file", file}, {"above", above.string()}});
  require(*folder.begin() != "~", "os.file.tilde", {{"file", file}});
  fail("os.file.no_folder", {{"file", file}, {"folder", folder.string()}});
}

/// The target of a link, which may not exist yet; follows at most 40 links, as the system does.
fs::path target_of(fs::path path) {
  std::error_code ignored;
  for (int i = 0; i < 40 && fs::is_symlink(path, ignored); ++i)
    path = path.parent_path() / fs::read_symlink(path, ignored);
  return path;
}

/// The number of an open stream of this process that a name denotes; −1 for other names.
int stream_of(const std::string& file) {
  return file == "/dev/stdout" ? STDOUT_FILENO : file == "/dev/stderr" ? STDERR_FILENO : -1;
}

/// Writes to a stream, a device or a pipe, such as /dev/null, which a rename would replace by a file.
void write_into(const std::string& file, std::string_view bytes) {
  if (const int stream = stream_of(file); stream >= 0) { // after what was printed, also if it is a file
    std::fflush(nullptr);
    if (!write_all(stream, bytes)) cannot_write(file, errno);
    return;
  }
  // A pipe that nobody reads would stop the program until somebody does.
  const int handle = ::open(file.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
  require(handle >= 0 || errno != ENXIO, "os.file.unread_pipe", {{"file", file}});
  const bool written = handle >= 0 && ::fcntl(handle, F_SETFL, 0) == 0 && write_all(handle, bytes);
  const int error = errno;
  if (handle >= 0) ::close(handle);
  if (!written) cannot_write(file, error);
}

/// True if bytes are written into what a name denotes, which is not replaced.
bool is_written_into(const std::string& file) {
  std::error_code ignored;
  return stream_of(file) >= 0 || fs::is_other(file, ignored);
}

/// Replaces a file or a link, or makes a new file.
void replace(const std::string& file, const fs::path& path, std::string_view bytes, bool durable) {
  Temporary temporary = temporary_for(path);
  if (temporary.handle < 0 || !write_all(temporary.handle, bytes)) cannot_write(file, errno);
  if (durable && ::fsync(temporary.handle) != 0) cannot_write(file, errno);
  if (!is_complete(temporary.handle) || ::rename(temporary.path.c_str(), path.c_str()) != 0) cannot_write(file, errno);
  temporary.kept = true;
}

/// Throws Error unless a name can be that of a file: its folder exists, and it is not a folder itself.
void check_place(const std::string& file, const fs::path& path) {
  check_folder(file, folder_of(path));
  std::error_code ignored;
  require(!fs::is_directory(path, ignored), "os.file.write_folder", {{"file", file}});
}

/// The first bytes of a file, by which kinds are told apart; empty if there is none.
std::string beginning_of(const fs::path& path) {
  std::string bytes(4096, '\0');
  const int handle = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (handle < 0 && errno != ENOENT) return "?"; // it cannot be read: its kind is unknown
  const ssize_t count = handle < 0 ? 0 : ::pread(handle, bytes.data(), bytes.size(), 0);
  if (handle >= 0) ::close(handle);
  bytes.resize(std::max<ssize_t>(count, 0));
  return bytes;
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
  require(file.find('\0') == std::string::npos, "os.file.zero", {{"file", file}});
}

void write_record(const std::string& file, std::string_view bytes, bool durable) {
  check_file_name(file);
  check_place(file, file);
  replace(file, file, bytes, durable);
}

std::string check_output(const std::string& file, FileKind kind) {
  check_file_name(file);
  require(fs::path(file).has_filename(), "os.file.no_name", {{"file", file}});
  if (is_written_into(file)) return file;
  const fs::path path = target_of(file);
  check_place(file, path);
  const std::string found = beginning_of(path);
  require(may_replace(path.string(), found, kind), "os.file.other_kind",
          {{"file", file}, {"found", name_of(kind_of(found))}, {"kind", name_of(kind)}});
  return path.string();
}

void write_output(const std::string& file, std::string_view bytes, FileKind kind, bool durable) {
  const std::string target = check_output(file, kind);
  if (is_written_into(file)) return write_into(file, bytes);
  replace(file, target, bytes, durable);
}

void move_output(const std::string& from, const std::string& file, FileKind kind) {
  if (::rename(from.c_str(), check_output(file, kind).c_str()) != 0) cannot_write(file, errno);
}

std::string read_file(const std::string& file) {
  check_file_name(file);
  std::error_code ignored;
  require(!fs::is_directory(file, ignored), "os.file.read_folder", {{"file", file}});
  // Pipes without a name in a folder, such as /dev/stdin and those of the shell, have no canonical path.
  const bool named = !fs::canonical(file, ignored).empty();
  require(!named || !fs::is_fifo(file, ignored), "os.file.read_pipe", {{"file", file}});
  std::ifstream in(file, std::ios::binary);
  require(in.good(), "os.file.read", {{"file", file}, {"reason", std::strerror(errno)}});
  std::ostringstream out;
  out << in.rdbuf();
  require(!in.bad(), "os.file.read_broken", {{"file", file}, {"reason", std::strerror(errno)}});
  return std::move(out).str();
}

} // namespace signorini
