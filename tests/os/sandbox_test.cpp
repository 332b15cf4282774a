// What the kernel stops in the sandbox, tried by raw system calls, as code would that has taken over the process: no
// function of Lua is in between. Each attempt is made in a child that has entered the sandbox; outside, the same
// attempt succeeds or fails in another way.

#include "os/sandbox.hpp"

#include "base/error.hpp"
#include "os/jobs.hpp"
#include "os/landlock.hpp"
#include "scratch.hpp"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <linux/sched.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <thread>
#include <unistd.h>

namespace signorini {
namespace sandbox_test {

namespace fs = std::filesystem;

/// The error number of a system call, 0 if it succeeded.
int error_of(long status) {
  return status < 0 ? errno : 0;
}

int open_for_reading(const fs::path& file) {
  return error_of(open(file.c_str(), O_RDONLY | O_CLOEXEC));
}
int open_for_writing(const fs::path& file) {
  return error_of(open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666));
}

/// The result of an attempt in a child, in the sandbox of a folder; -1 if the child ended in another way. Errors of
/// entering are thrown in the child, whose result then is 255.
int inside(const fs::path& folder, int landlock, const std::function<int()>& attempt) {
  const pid_t child = fork();
  if (child == 0) {
    try {
      enter_sandbox({folder, {}, 2}, landlock);
    } catch (const Error& error) {
      std::fprintf(stderr, "%s\n", error.what());
      _exit(255);
    }
    _exit(attempt());
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}
int inside(const fs::path& folder, const std::function<int()>& attempt) {
  return inside(folder, landlock_version(), attempt);
}

class Sandboxed : public testing::Test {
protected:
  void SetUp() override {
    if (const auto missing = sandbox_missing()) GTEST_SKIP() << "no sandbox here: " << bare_text(*missing);
    fs::create_directory(folder);
    fs::create_directory(outside);
    std::ofstream(outside / "secret") << "secret";
    std::ofstream(folder / "own") << "own";
  }

  test::ScratchFolder scratch;
  fs::path folder = scratch.file("in"), outside = scratch.file("out"), secret = outside / "secret";
};

TEST_F(Sandboxed, AllowsWorkInTheFolder) {
  EXPECT_EQ(inside(folder,
                   [&] {
                     std::ofstream("made") << "text"; // the folder is the working directory
                     int failed = error_of(mkdir("below", 0777)) + error_of(rename("made", "below/made"));
                     failed += open_for_reading("below/made") + open_for_writing(folder / "own");
                     failed += open_for_reading("/usr/bin/env") + open_for_writing("/dev/null");
                     return failed + error_of(unlink("below/made")) + error_of(rmdir("below"));
                   }),
            0);
}

TEST_F(Sandboxed, AllowsThreadsAndJobs) {
  if (landlock_version() < landlock_confines_signals) GTEST_SKIP() << "jobs need Linux 6.12";
  EXPECT_EQ(inside(folder,
                   [&] {
                     std::atomic<int> count = 0;
                     std::thread([&] { ++count; }).join();
                     const auto job = [](int i) { return std::to_string(i); };
                     run_jobs(3, {.at_once = 1000}, job, [&](const JobEnd& end) { count += end.output.size(); });
                     return count.load();
                   }),
            4);
}

TEST_F(Sandboxed, KillsALateJob) {
  if (landlock_version() < landlock_confines_signals) GTEST_SKIP() << "jobs need Linux 6.12";
  EXPECT_EQ(inside(folder,
                   [&] {
                     int late = 0;
                     const auto job = [](int) {
                       for (;;) pause();
                       return std::string();
                     };
                     run_jobs(1, {.at_once = 1, .seconds = 0.1}, job,
                              [&](const JobEnd& end) { late = end.failure.code == "os.jobs.time"; });
                     return late;
                   }),
            1);
}

TEST_F(Sandboxed, StopsJobsThatStartJobs) {
  if (landlock_version() < landlock_confines_signals) GTEST_SKIP() << "jobs need Linux 6.12";
  EXPECT_EQ(inside(folder,
                   [&] {
                     int reason = 0;
                     const auto job = [](int) { return std::to_string(error_of(fork())); };
                     run_jobs(1, {}, job, [&](const JobEnd& end) { reason = std::atoi(end.output.c_str()); });
                     return reason;
                   }),
            EPERM);
}

// ── Stopped by Landlock ──────────────────────────────────────────────────────────────────────────────────────────────

TEST_F(Sandboxed, LandlockStopsFilesOutside) {
  ASSERT_EQ(open_for_reading(secret), 0);
  fs::create_symlink(secret, folder / "link");
  fs::create_symlink(outside / "new", folder / "link_to_new");
  for (const fs::path& file : {secret, fs::path("../out/secret"), folder / "link", fs::path("/etc/passwd"),
                               fs::path("/proc/1/environ"), fs::path("/proc/self/environ"), fs::path("/proc/self/mem"),
                               fs::path("/proc/self/maps"), fs::path("/dev/mem"), fs::path("/etc/shadow")}) {
    if (!fs::exists(file.is_absolute() ? file : folder / file)) continue;
    EXPECT_EQ(inside(folder, [&] { return open_for_reading(file); }), EACCES) << file;
  }
  for (const fs::path& file : {secret, outside / "new", fs::path("../out/new"), folder / "link", folder / "link_to_new",
                               fs::temp_directory_path() / "new_of_sandbox", fs::path("/dev/shm/new_of_sandbox")})
    EXPECT_EQ(inside(folder, [&] { return open_for_writing(file); }), EACCES) << file;
  EXPECT_EQ(inside(folder, [&] { return error_of(open("/", O_RDONLY | O_DIRECTORY)); }), EACCES);
  EXPECT_FALSE(fs::exists(outside / "new"));
}

TEST_F(Sandboxed, LandlockStopsMovesAcrossTheBorder) {
  const fs::path own = folder / "own", moved = outside / "moved";
  EXPECT_NE(inside(folder, [&] { return error_of(rename(own.c_str(), moved.c_str())); }), 0);
  EXPECT_NE(inside(folder, [&] { return error_of(link(own.c_str(), moved.c_str())); }), 0);
  EXPECT_NE(inside(folder, [&] { return error_of(rename(secret.c_str(), "taken")); }), 0);
  EXPECT_NE(inside(folder, [&] { return error_of(link(secret.c_str(), "taken")); }), 0);
  EXPECT_EQ(inside(folder, [&] { return error_of(unlink(secret.c_str())); }), EACCES);
  EXPECT_EQ(inside(folder, [&] { return error_of(mkdir((outside / "made").c_str(), 0777)); }), EACCES);
  EXPECT_TRUE(fs::exists(own));
  EXPECT_TRUE(fs::exists(secret));
  EXPECT_FALSE(fs::exists(moved));
}

TEST_F(Sandboxed, LandlockOrTheFilterStopsSignals) {
  const pid_t victim = fork();
  if (victim == 0)
    for (;;) pause();
  for (const int version : {landlock_version(), 1}) {
    EXPECT_EQ(inside(folder, version, [&] { return error_of(kill(victim, SIGKILL)); }), EPERM) << version;
    EXPECT_EQ(inside(folder, version, [&] { return error_of(kill(getppid(), 0)); }), EPERM) << version;
    EXPECT_EQ(inside(folder, version, [&] { return error_of(raise(SIGURG)); }), 0) << version;
  }
  EXPECT_EQ(waitpid(victim, nullptr, WNOHANG), 0);
  kill(victim, SIGKILL);
  waitpid(victim, nullptr, 0);
}

TEST_F(Sandboxed, StopsJobsWhereSignalsAreNotConfined) {
  EXPECT_EQ(inside(folder, 5, [&] { return error_of(fork()); }), EPERM);
  const auto refused = [] {
    const auto message = test::message_of([] {
      run_jobs(
          1, {}, [](int) { return ""; }, [](const JobEnd&) {});
    });
    return static_cast<int>(message.starts_with("os.jobs.sandbox"));
  };
  EXPECT_EQ(inside(folder, 5, refused), 1);
}

TEST_F(Sandboxed, ConfinesFilesWithEveryVersionOfLandlock) {
  for (int version = 1; version <= landlock_version(); ++version) {
    EXPECT_EQ(inside(folder, version, [&] { return open_for_reading(secret); }), EACCES) << version;
    EXPECT_EQ(inside(folder, version, [&] { return open_for_writing(folder / "own"); }), 0) << version;
    EXPECT_NE(inside(folder, version, [&] { return error_of(truncate(secret.c_str(), 0)); }), 0) << version;
  }
  EXPECT_EQ(fs::file_size(secret), 6);
}

// ── Stopped by the filter of system calls ────────────────────────────────────────────────────────────────────────────

TEST_F(Sandboxed, TheFilterStopsPrograms) {
  const auto run = [&](const char* program) {
    char* const words[] = {const_cast<char*>(program), nullptr};
    return error_of(execve(program, words, words));
  };
  fs::copy("/bin/true", folder / "own_program");
  EXPECT_EQ(inside(folder, [&] { return run("/bin/true"); }), EPERM);
  EXPECT_EQ(inside(folder, [&] { return run("./own_program"); }), EPERM);
  EXPECT_EQ(inside(folder, [&] { return WEXITSTATUS(std::system("true")); }), 127);
}

TEST_F(Sandboxed, TheFilterStopsSockets) {
  for (const int family : {AF_UNIX, AF_INET, AF_INET6, AF_NETLINK, AF_VSOCK})
    EXPECT_EQ(inside(folder, [&] { return error_of(socket(family, SOCK_STREAM, 0)); }), EPERM) << family;
  int ends[2];
  EXPECT_EQ(inside(folder, [&] { return error_of(socketpair(AF_UNIX, SOCK_STREAM, 0, ends)); }), EPERM);
}

TEST_F(Sandboxed, TheFilterStopsWhatReachesOtherProcessesOrTheSystem) {
  const pid_t self = getpid();
  char byte = 0;
  const iovec here{&byte, 1};
  const auto call = [](long number, auto... arguments) { return error_of(syscall(number, arguments...)); };
  const std::pair<const char*, std::function<int()>> attempts[] = {
      {"ptrace", [&] { return call(SYS_ptrace, PTRACE_ATTACH, self, 0, 0); }},
      {"process_vm_readv", [&] { return call(SYS_process_vm_readv, self, &here, 1, &here, 1, 0); }},
      {"process_vm_writev", [&] { return call(SYS_process_vm_writev, self, &here, 1, &here, 1, 0); }},
      {"pidfd_open", [&] { return call(SYS_pidfd_open, self, 0); }},
      {"mount", [&] { return call(SYS_mount, "none", folder.c_str(), "tmpfs", 0, nullptr); }},
      {"chroot", [&] { return call(SYS_chroot, folder.c_str()); }},
      {"unshare", [&] { return call(SYS_unshare, CLONE_NEWUSER); }},
      {"setns", [&] { return call(SYS_setns, 0, 0); }},
      {"clone in a namespace", [&] { return call(SYS_clone, CLONE_NEWUSER | SIGCHLD, 0, 0, 0, 0); }},
      {"io_uring_setup", [&] { return call(SYS_io_uring_setup, 1, nullptr); }},
      {"bpf", [&] { return call(SYS_bpf, 0, nullptr, 0); }},
      {"perf_event_open", [&] { return call(SYS_perf_event_open, nullptr, 0, -1, -1, 0); }},
      {"userfaultfd", [&] { return call(SYS_userfaultfd, 0); }},
      {"keyctl", [&] { return call(SYS_keyctl, 0, 0, 0, 0, 0); }},
      {"init_module", [&] { return call(SYS_init_module, nullptr, 0, ""); }},
      {"finit_module", [&] { return call(SYS_finit_module, 0, "", 0); }},
      {"kexec_load", [&] { return call(SYS_kexec_load, 0, 0, nullptr, 0); }},
      {"reboot", [&] { return call(SYS_reboot, 0, 0, 0, nullptr); }},
      {"setuid", [&] { return call(SYS_setuid, 1234); }},
      {"memfd_create", [&] { return call(SYS_memfd_create, "a", 0); }},
      {"open_by_handle_at", [&] { return call(SYS_open_by_handle_at, 0, nullptr, 0); }},
      {"chmod outside", [&] { return error_of(chmod(secret.c_str(), 0)); }},
      {"chown outside", [&] { return error_of(chown(secret.c_str(), 0, 0)); }},
      {"utimensat outside", [&] { return error_of(utimensat(AT_FDCWD, secret.c_str(), nullptr, 0)); }},
      {"setxattr outside", [&] { return error_of(setxattr(secret.c_str(), "user.a", "b", 1, 0)); }},
      {"truncate outside", [&] { return error_of(truncate(secret.c_str(), 0)); }},
      {"symlink", [&] { return error_of(symlink(secret.c_str(), "trap")); }},
      {"mknod", [&] { return error_of(mknod("device", S_IFCHR | 0600, 0x103)); }},
      {"typing into the terminal", [&] { return error_of(ioctl(0, TIOCSTI, &byte)); }},
      {"the same with high bits", [&] { return call(SYS_ioctl, 0, TIOCSTI | 1UL << 32, &byte); }},
      {"signals by a file's owner", [&] { return error_of(fcntl(0, F_SETOWN, self)); }},
      {"limits of another process", [&] { return call(SYS_prlimit64, self, RLIMIT_CORE, nullptr, nullptr); }},
      {"uncounted memory",
       [&] { return mmap(nullptr, 4096, PROT_READ, MAP_SHARED | MAP_ANONYMOUS, -1, 0) == MAP_FAILED ? errno : 0; }}};
  for (const auto& [name, attempt] : attempts) EXPECT_EQ(inside(folder, attempt), EPERM) << name;
}

TEST_F(Sandboxed, TheFilterHoldsForThreads) {
  EXPECT_EQ(inside(folder,
                   [&] {
                     int failure = 0;
                     std::thread([&] {
                       failure =
                           error_of(socket(AF_INET, SOCK_STREAM, 0)) == EPERM && open_for_reading(secret) == EACCES;
                     }).join();
                     return failure;
                   }),
            1);
}

TEST_F(Sandboxed, ClosesFilesThatAreOpen) {
  const int file = open(secret.c_str(), O_RDONLY);
  ASSERT_GE(file, 3);
  char byte;
  EXPECT_EQ(inside(folder, [&] { return error_of(::read(file, &byte, 1)); }), EBADF);
  close(file);
}

// ── Refused folders ──────────────────────────────────────────────────────────────────────────────────────────────────

std::string refusal(const Sandbox& sandbox) {
  const std::string message = test::message_of([&] { check_sandbox(sandbox); });
  return message.substr(0, message.find(':'));
}

TEST_F(Sandboxed, RefusesFoldersThatOthersTrust) {
  EXPECT_EQ(refusal({folder}), "no error");
  EXPECT_EQ(refusal({scratch.file("missing")}), "os.sandbox.folder");
  EXPECT_EQ(refusal({folder / "own"}), "os.sandbox.folder");
  for (const char* place : {"/", "/usr", "/etc", "/proc", "/dev"})
    EXPECT_EQ(refusal({place}), "os.sandbox.contains") << place;
  if (const char* home = std::getenv("HOME"); home && fs::exists(home)) {
    EXPECT_EQ(refusal({home}), "os.sandbox.contains");
  }
  EXPECT_EQ(refusal({fs::read_symlink("/proc/self/exe").parent_path()}), "os.sandbox.contains");
  EXPECT_EQ(refusal({folder.parent_path(), {folder}}), "os.sandbox.contains");
  fs::create_directory(folder / "below");
  EXPECT_EQ(refusal({folder / "below", {folder}}), "os.sandbox.inside");
}

TEST_F(Sandboxed, IsNotEnteredWhileOtherThreadsRun) {
  EXPECT_DEATH(
      {
        std::atomic<bool> over = false;
        std::thread other([&] { over.wait(false); });
        try {
          enter_sandbox({folder});
        } catch (const Error& error) {
          std::fprintf(stderr, "%s\n", error.what());
        }
        _exit(1);
      },
      "os.sandbox.threads");
}

TEST_F(Sandboxed, EnvironmentIsWithoutSecrets) {
  setenv("SECRET_TOKEN", "a", 1);
  setenv("LC_TIME", "C", 1);
  bool kept = false;
  for (const std::string& variable : sandbox_environment(folder)) {
    EXPECT_FALSE(variable.starts_with("SECRET_TOKEN=") || variable.starts_with("HOME=")) << variable;
    kept = kept || variable == "LC_TIME=C";
  }
  EXPECT_TRUE(kept);
  unsetenv("SECRET_TOKEN");
  unsetenv("LC_TIME");
}

} // namespace sandbox_test
} // namespace signorini
