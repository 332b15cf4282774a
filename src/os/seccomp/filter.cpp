// The system calls that a run in the sandbox may make. Whatever is not listed, also what later kernels add, fails with
// EPERM: execve, sockets, ptrace, mount, namespaces, modules, bpf, io_uring, process_vm_*, keys, and the calls by which
// files outside could be changed although Landlock does not confine them: chmod, chown, utimensat, setxattr, truncate.

#include "os/seccomp_module.hpp"

#include <cerrno>
#include <fcntl.h>
#include <initializer_list>
#include <linux/sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <termios.h>
#include <unistd.h>

namespace signorini {

namespace {

constexpr const char* allowed[] = {
    // files
    "read", "write", "readv", "writev", "pread64", "pwrite64", "preadv", "pwritev", "preadv2", "pwritev2", "open",
    "openat", "close", "close_range", "stat", "fstat", "lstat", "newfstatat", "statx", "statfs", "fstatfs", "lseek",
    "access", "faccessat", "faccessat2", "readlink", "readlinkat", "getcwd", "chdir", "fchdir", "getdents",
    "getdents64", "mkdir", "mkdirat", "rmdir", "unlink", "unlinkat", "rename", "renameat", "renameat2", "link",
    "linkat", "ftruncate", "fsync", "fdatasync", "fallocate", "fadvise64", "flock", "dup", "dup2", "dup3", "pipe",
    "pipe2", "poll", "ppoll", "select", "pselect6", "sendfile", "copy_file_range", "umask", "eventfd2",
    // memory
    "brk", "munmap", "mremap", "mprotect", "madvise", "mincore", "msync", "membarrier", "get_mempolicy",
    // threads and processes
    "futex", "set_robust_list", "get_robust_list", "rseq", "set_tid_address", "arch_prctl", "exit", "exit_group",
    "wait4", "waitid", "getpid", "gettid", "getppid", "getpgrp", "getpgid", "getsid", "getuid", "geteuid", "getgid",
    "getegid", "getgroups", "sched_yield", "sched_getaffinity", "sched_getparam", "sched_getscheduler",
    "sched_get_priority_max", "sched_get_priority_min", "getcpu", "getrlimit", "setrlimit", "seccomp",
    // signals and time
    "rt_sigaction", "rt_sigprocmask", "rt_sigreturn", "rt_sigpending", "rt_sigtimedwait", "rt_sigsuspend",
    "sigaltstack", "pause", "restart_syscall", "setitimer", "getitimer", "alarm", "clock_gettime", "clock_getres",
    "clock_nanosleep", "nanosleep", "gettimeofday", "time", "times", "getrusage",
    // the machine
    "uname", "sysinfo", "getrandom"};

/// A call that is allowed if an argument has one of these values.
struct Limited {
  const char* call;
  unsigned argument;
  std::initializer_list<scmp_datum_t> values;
};

// TIOCSTI and TIOCLINUX would type into the user's terminal; F_SETOWN would have signals sent to other processes.
const Limited limited[] = {
    {"ioctl", 1, {TCGETS, TCSETS, TCSETSW, TCSETSF, TIOCGWINSZ, TIOCGPGRP, FIONREAD, FIOCLEX, FIONCLEX}},
    {"fcntl",
     1,
     {F_DUPFD, F_DUPFD_CLOEXEC, F_GETFD, F_SETFD, F_GETFL, F_SETFL, F_GETLK, F_SETLK, F_SETLKW, F_OFD_GETLK,
      F_OFD_SETLK, F_OFD_SETLKW}},
    {"prctl", 0, {PR_SET_PDEATHSIG, PR_SET_NAME, PR_GET_NAME, PR_SET_NO_NEW_PRIVS}},
    {"prlimit64", 0, {0}},
    {"sched_setaffinity", 0, {0}}};

constexpr scmp_datum_t namespaces = CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER |
                                    CLONE_NEWPID | CLONE_NEWNET | CLONE_PTRACE | CLONE_PARENT;

/// Rules that are added one after the other until one fails.
class Filter {
public:
  explicit Filter(std::uint32_t otherwise) : context_(seccomp_init(otherwise)) {
    if (!context_) error_ = ENOMEM;
    // Applied to all threads; no_new_privs is set already.
    if (context_) check(seccomp_attr_set(context_, SCMP_FLTATR_CTL_TSYNC, 1));
    if (context_) check(seccomp_attr_set(context_, SCMP_FLTATR_CTL_NNP, 0));
  }
  ~Filter() {
    if (context_) seccomp_release(context_);
  }
  Filter(const Filter&) = delete;
  Filter& operator=(const Filter&) = delete;

  /// Calls that this processor does not have are left out.
  void add(std::uint32_t action, const char* call, std::initializer_list<scmp_arg_cmp> conditions = {}) {
    const int number = seccomp_syscall_resolve_name(call);
    if (error_ || number < 0) return;
    check(
        seccomp_rule_add_array(context_, action, number, static_cast<unsigned>(conditions.size()), conditions.begin()));
  }

  int load() {
    if (!error_) check(seccomp_load(context_));
    return error_;
  }

private:
  void check(int status) {
    if (status < 0 && !error_) error_ = -status;
  }

  scmp_filter_ctx context_;
  int error_ = 0;
};

scmp_arg_cmp equal(unsigned argument, scmp_datum_t value) {
  return {argument, SCMP_CMP_EQ, value, 0};
}
/// True if the argument has these of the bits in the mask.
scmp_arg_cmp bits(unsigned argument, scmp_datum_t mask, scmp_datum_t value) {
  return {argument, SCMP_CMP_MASKED_EQ, mask, value};
}

int filter(bool forks) {
  Filter rules(SCMP_ACT_ERRNO(EPERM));
  for (const char* call : allowed) rules.add(SCMP_ACT_ALLOW, call);
  for (const Limited& call : limited)
    for (const scmp_datum_t value : call.values) rules.add(SCMP_ACT_ALLOW, call.call, {equal(call.argument, value)});
  // Shared memory without a file is not counted by RLIMIT_DATA.
  rules.add(SCMP_ACT_ALLOW, "mmap", {bits(3, MAP_ANONYMOUS, 0)});
  rules.add(SCMP_ACT_ALLOW, "mmap", {bits(3, MAP_SHARED, 0)});
  // The flags of clone3() are in memory, where filters cannot read them: without it the C library uses clone().
  rules.add(SCMP_ACT_ERRNO(ENOSYS), "clone3");
  if (forks) {
    rules.add(SCMP_ACT_ALLOW, "clone", {bits(0, namespaces, 0)});
    for (const char* call : {"kill", "tgkill"}) rules.add(SCMP_ACT_ALLOW, call);
  } else {
    rules.add(SCMP_ACT_ALLOW, "clone", {bits(0, namespaces | CLONE_THREAD, CLONE_THREAD)});
    for (const char* call : {"kill", "tgkill"})
      rules.add(SCMP_ACT_ALLOW, call, {equal(0, static_cast<scmp_datum_t>(getpid()))});
  }
  return rules.load();
}

int forbid_forks() {
  Filter rules(SCMP_ACT_ALLOW);
  rules.add(SCMP_ACT_ERRNO(EPERM), "clone", {bits(0, CLONE_THREAD, 0)});
  return rules.load();
}

std::string version() {
  const scmp_version* v = seccomp_version();
  return std::to_string(v->major) + "." + std::to_string(v->minor) + "." + std::to_string(v->micro);
}

} // namespace

extern "C" {
extern const SeccompModule signorini_sandbox;
const SeccompModule signorini_sandbox = {version, filter, forbid_forks};
}

} // namespace signorini
