#include "os/landlock.hpp"

#include "base/error.hpp"

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace signorini {

namespace {

// Rights that older headers lack.
constexpr std::uint64_t access_truncate = 1ULL << 14;                         // from version 3 on
constexpr std::uint64_t access_ioctl = 1ULL << 15;                            // 5
constexpr std::uint64_t net_bind = 1ULL << 0, net_connect = 1ULL << 1;        // 4
constexpr std::uint64_t scope_abstract = 1ULL << 0, scope_signal = 1ULL << 1; // 6

struct Attributes {
  std::uint64_t files = 0, net = 0, scoped = 0;
};

constexpr std::uint64_t file_reading = LANDLOCK_ACCESS_FS_READ_FILE, folder_reading = LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t file_rights = file_reading | LANDLOCK_ACCESS_FS_WRITE_FILE | access_truncate;
constexpr std::uint64_t folder_writing = file_rights | folder_reading | LANDLOCK_ACCESS_FS_REMOVE_DIR |
                                         LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_DIR |
                                         LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_REFER;
/// All rights of version 1.
constexpr std::uint64_t first_rights = (1ULL << 13) - 1;

Attributes attributes_of(int version) {
  Attributes all{first_rights, 0, 0};
  if (version >= 2) all.files |= LANDLOCK_ACCESS_FS_REFER;
  if (version >= 3) all.files |= access_truncate;
  if (version >= 4) all.net = net_bind | net_connect;
  if (version >= 5) all.files |= access_ioctl;
  if (version >= landlock_confines_signals) all.scoped = scope_abstract | scope_signal;
  return all;
}

std::size_t size_of_attributes(int version) {
  if (version < 4) return offsetof(Attributes, net);
  return version < landlock_confines_signals ? offsetof(Attributes, scoped) : sizeof(Attributes);
}

void check(long status) {
  require(status >= 0, "os.sandbox.landlock", {{"reason", std::strerror(errno)}});
}

} // namespace

int landlock_version() {
  const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  return version > 0 ? static_cast<int>(version) : 0;
}

Landlock::Landlock(int version) {
  const Attributes all = attributes_of(version);
  handled_ = all.files;
  const long made = syscall(SYS_landlock_create_ruleset, &all, size_of_attributes(version), 0);
  check(made);
  rules_ = static_cast<int>(made);
}

Landlock::~Landlock() {
  if (rules_ >= 0) close(rules_);
}

void Landlock::allow_reading(const std::filesystem::path& path) {
  allow(path, file_reading | folder_reading);
}

void Landlock::allow_writing(const std::filesystem::path& path) {
  allow(path, folder_writing);
}

void Landlock::allow(const std::filesystem::path& path, unsigned long long access) {
  const int place = open(path.c_str(), O_PATH | O_CLOEXEC);
  if (place < 0) return;
  struct stat about {};
  const bool folder = fstat(place, &about) == 0 && S_ISDIR(about.st_mode);
  const landlock_path_beneath_attr rule{handled_ & (folder ? access : access & file_rights), place};
  const long status = syscall(SYS_landlock_add_rule, rules_, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
  const int error = errno;
  close(place);
  errno = error;
  check(status);
}

void Landlock::restrict() const {
  check(syscall(SYS_landlock_restrict_self, rules_, 0));
}

} // namespace signorini
