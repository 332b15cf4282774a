#include "os/process.hpp"

#include "base/error.hpp"
#include "os/sandbox.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

namespace signorini {
namespace {

constexpr std::size_t kept_bytes = 600; // bytes of a program's output

/// The output of a pipe up to its end, or the last bytes of it.
std::string last_output(int pipe) {
  std::string output;
  std::array<char, 4096> buffer;
  for (;;) {
    const ssize_t got = ::read(pipe, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return output;
    output.append(buffer.data(), got);
    if (output.size() > kept_bytes) output.erase(0, output.size() - kept_bytes);
  }
}

int wait_for(pid_t id) {
  int status = 0;
  while (::waitpid(id, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

} // namespace

bool has_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access(text(folder, "/", name).c_str(), X_OK) == 0) return true;
  return false;
}

std::string run_program(const std::vector<std::string>& words) {
  require(sandbox_folder().empty(), "os.process.sandbox", {{"program", words[0]}});
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  int ends[2];
  require(::pipe2(ends, O_CLOEXEC) == 0, "os.process.start", {{"program", words[0]}, {"reason", std::strerror(errno)}});
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], 1);
  posix_spawn_file_actions_adddup2(&actions, ends[1], 2);
  pid_t id;
  const int failed = ::posix_spawnp(&id, words[0].c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  const std::string output = failed ? "" : last_output(ends[0]);
  ::close(ends[0]);
  require(failed == 0, "os.process.start", {{"program", words[0]}, {"reason", std::strerror(failed)}});
  const int status = wait_for(id);
  require(WIFEXITED(status) && WEXITSTATUS(status) == 0, "os.process.failed",
          {{"program", words[0]}, {"output", output}});
  return output;
}

} // namespace signorini
