#pragma once
// The sandbox of --sandbox: from some point on the process reads the program and the system's libraries, reads and
// writes below one folder, starts no program and opens no socket. The kernel enforces it: Landlock confines files and
// signals, seccomp system calls.

#include "base/message.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace signorini {

struct Sandbox {
  std::filesystem::path folder; ///< read and written
  std::vector<std::filesystem::path> read =
      {};            ///< files and folders that are also read; those that do not exist are ignored
  int processes = 1; ///< that run_jobs() runs in parallel, at most
};

/// Why this system or installation has no sandbox; nothing if it has one.
std::optional<Message> sandbox_missing();

/// "Landlock 7, libseccomp 2.5.4". Throws Error where sandbox_missing().
std::string sandbox_description();

/// The environment inside the sandbox: variables of language, terminal and the program; without the user's secrets and
/// folders; the libraries start no threads. "NAME=value" each.
std::vector<std::string> sandbox_environment(const std::filesystem::path& folder);

/// Throws Error where sandbox_missing(), unless the folder is one, and if it is, contains or (of the program's library)
/// is inside a place on which other programs or later runs rely: the program, the system, the user's home.
void check_sandbox(const Sandbox& sandbox);

/// Enters the sandbox, which no thread of the process and none of its children leaves again. The folder becomes the
/// working directory; open files other than standard input, output and error are closed. Throws Error, and the process
/// must not continue, as check_sandbox() does, and while there are other threads. `most` limits the version of
/// Landlock's interface, as on an older kernel.
void enter_sandbox(const Sandbox& sandbox, int most = 1 << 10);

/// The folder of the sandbox in which the process is; empty outside.
const std::filesystem::path& sandbox_folder();

/// The parallel processes that the sandbox allows; 0 on kernels that cannot confine signals (before Linux 6.12).
int sandbox_processes();

/// In a child: forbids further children. Nothing outside a sandbox.
void forbid_children();

} // namespace signorini
