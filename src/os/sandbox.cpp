#include "os/sandbox.hpp"

#include "base/error.hpp"
#include "os/landlock.hpp"
#include "os/machine.hpp"
#include "os/module.hpp"
#include "os/seccomp_module.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <link.h>
#include <linux/seccomp.h>
#include <pwd.h>
#include <string_view>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace signorini {

namespace fs = std::filesystem;

namespace {

constexpr const char* seccomp_file = "signorini_sandbox.so";

/// Libraries, fonts, terminals and time zones; what the C library, OpenBLAS and Mesa read about the machine.
constexpr const char* system_places[] = {"/usr",
                                         "/lib",
                                         "/lib64",
                                         "/etc/ld.so.cache",
                                         "/etc/fonts",
                                         "/var/cache/fontconfig",
                                         "/etc/terminfo",
                                         "/etc/inputrc",
                                         "/etc/localtime",
                                         "/etc/alternatives",
                                         "/proc/cpuinfo",
                                         "/proc/meminfo",
                                         "/proc/stat",
                                         "/sys/devices/system/cpu",
                                         "/sys/devices/system/node"};
constexpr const char* devices_read[] = {"/dev/urandom", "/dev/random", "/dev/zero"};
constexpr const char* devices_written[] = {"/dev/null", "/dev/full"};

fs::path folder_inside;
int processes_inside = 0;
const SeccompModule* module_inside = nullptr;

const SeccompModule& seccomp() {
  const fs::path file = find_module(seccomp_file);
  const auto [first, second] = module_folders();
  require(!file.empty(), "os.sandbox.missing",
          {{"module", seccomp_file}, {"first", first.string()}, {"second", second.string()}});
  return *static_cast<const SeccompModule*>(load_module(file, "signorini_sandbox"));
}

/// True if a folder is, or contains, a place.
bool contains(const fs::path& folder, const fs::path& place) {
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), place.begin(), place.end());
  return end == folder.end();
}

/// The folders of the libraries that are loaded, which need not be below /usr.
std::vector<fs::path> library_folders() {
  std::vector<fs::path> folders;
  dl_iterate_phdr(
      [](dl_phdr_info* library, std::size_t, void* found) {
        const fs::path file = library->dlpi_name; // without a folder: the program, or the kernel's own
        std::error_code ignored;
        if (file.is_absolute())
          static_cast<std::vector<fs::path>*>(found)->push_back(fs::weakly_canonical(file, ignored).parent_path());
        return 0;
      },
      &folders);
  return folders;
}

void check_single_thread() {
  std::error_code ignored;
  const auto threads = std::distance(fs::directory_iterator("/proc/self/task", ignored), fs::directory_iterator());
  require(threads <= 1, "os.sandbox.threads", {{"threads", static_cast<int>(threads)}});
}

/// The places on which other programs, or later runs of this one, rely: a script that could write there would act after
/// the sandbox has ended.
std::vector<fs::path> trusted_places(const std::vector<fs::path>& read) {
  std::vector<fs::path> places(std::begin(system_places), std::end(system_places));
  for (const fs::path& place : read)
    if (fs::is_directory(place)) places.push_back(place);
  places.insert(places.end(), {"/proc", "/sys", "/dev", "/etc", program_file()});
  if (const char* home = std::getenv("HOME"); home && *home) places.emplace_back(home);
  if (const passwd* user = ::getpwuid(::getuid())) places.emplace_back(user->pw_dir);
  return places;
}

} // namespace

std::optional<Message> sandbox_missing() {
  if (landlock_version() == 0) return Message("os.sandbox.no_landlock");
  const unsigned action = SECCOMP_RET_ERRNO;
  if (syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) != 0) return Message("os.sandbox.no_seccomp");
  try {
    seccomp();
  } catch (const Error& error) {
    return error.message();
  }
  return std::nullopt;
}

std::string sandbox_description() {
  if (const auto reason = sandbox_missing()) throw Error(*reason);
  return text("Landlock ", landlock_version(), ", libseccomp ", seccomp().version());
}

std::vector<std::string> sandbox_environment(const fs::path& folder) {
  constexpr std::string_view kept[] = {"PATH",
                                       "LANG",
                                       "LANGUAGE",
                                       "TZ",
                                       "TERM",
                                       "COLORTERM",
                                       "NO_COLOR",
                                       "COLUMNS",
                                       "LINES",
                                       "LD_LIBRARY_PATH",
                                       "LIBGL_ALWAYS_SOFTWARE"};
  constexpr std::string_view begun[] = {"LC_", "SIGNORINI_", "TERM_PROGRAM", "KITTY_WINDOW", "OPENBLAS_CORETYPE"};
  std::vector<std::string> variables;
  for (char** entry = environ; *entry; ++entry) {
    const std::string_view variable = *entry, name = variable.substr(0, variable.find('='));
    if (std::find(std::begin(kept), std::end(kept), name) != std::end(kept) ||
        std::any_of(std::begin(begun), std::end(begun), [&](auto start) { return name.starts_with(start); }))
      variables.emplace_back(variable);
  }
  // Threads that a library starts while it is loaded would run outside; Mesa's cache of shaders is in the user's home.
  variables.insert(variables.end(), {"OPENBLAS_NUM_THREADS=1", "OMP_NUM_THREADS=1", "MESA_SHADER_CACHE_DISABLE=true",
                                     text("TMPDIR=", folder.string()), text("PWD=", folder.string())});
  return variables;
}

void check_sandbox(const Sandbox& sandbox) {
  if (const auto reason = sandbox_missing()) throw Error(*reason);
  std::error_code error;
  const fs::path folder = fs::canonical(sandbox.folder, error);
  require(!error && fs::is_directory(folder), "os.sandbox.folder",
          {{"folder", sandbox.folder.string()}, {"reason", error ? error.message() : std::strerror(ENOTDIR)}});
  for (const fs::path& place : trusted_places(sandbox.read)) {
    const fs::path real = fs::weakly_canonical(place, error);
    if (error || !fs::exists(real)) continue;
    require(!contains(folder, real), "os.sandbox.contains", {{"folder", folder.string()}, {"place", real.string()}});
  }
  for (const fs::path& place : sandbox.read)
    require(!fs::is_directory(place) || !contains(fs::weakly_canonical(place), folder), "os.sandbox.inside",
            {{"folder", folder.string()}, {"place", place.string()}});
}

void enter_sandbox(const Sandbox& sandbox, int most) {
  check_sandbox(sandbox);
  check_single_thread();
  const fs::path folder = fs::canonical(sandbox.folder);
  module_inside = &seccomp();
  require(::chdir(folder.c_str()) == 0, "os.sandbox.folder",
          {{"folder", folder.string()}, {"reason", std::strerror(errno)}});
  constexpr unsigned first_closed = 3;
  ::close_range(first_closed, ~0U, 0);
  const rlimit no_core{0, 0}; // the system's handler of core files would run outside
  ::setrlimit(RLIMIT_CORE, &no_core);
  require(::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0, "os.sandbox.seccomp", {{"reason", std::strerror(errno)}});

  const int version = std::min(landlock_version(), most);
  Landlock rules(version);
  for (const char* place : system_places) rules.allow_reading(place);
  for (const char* device : devices_read) rules.allow_reading(device);
  for (const char* device : devices_written) rules.allow_writing(device);
  for (const fs::path& place : library_folders()) rules.allow_reading(place);
  for (const fs::path& place : module_folders()) rules.allow_reading(place);
  for (const fs::path& place : sandbox.read) rules.allow_reading(place);
  rules.allow_writing(folder);
  rules.restrict();
  // Without rules for signals, only a filter confines them: to this process alone, which then has no children.
  const bool forks = version >= landlock_confines_signals;
  const int error = module_inside->filter(forks);
  require(error == 0, "os.sandbox.seccomp", {{"reason", std::strerror(error)}});
  folder_inside = folder;
  processes_inside = forks ? sandbox.processes : 0;
}

const fs::path& sandbox_folder() {
  return folder_inside;
}

int sandbox_processes() {
  return processes_inside;
}

void forbid_children() {
  if (!module_inside) return;
  const int error = module_inside->forbid_forks();
  require(error == 0, "os.sandbox.seccomp", {{"reason", std::strerror(error)}});
}

} // namespace signorini
