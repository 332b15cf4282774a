#include "os/jobs.hpp"

#include "base/error.hpp"
#include "base/notice.hpp"
#include "os/interrupt.hpp"
#include "os/parallel.hpp"
#include "os/sandbox.hpp"
#include "os/timer.hpp"
#include "os/whole_file.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <iostream>
#include <list>
#include <optional>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace signorini {

namespace {

// First byte that a child writes: whether its output or an error message follows.
constexpr char returned = 'r', threw = 't';

constexpr int poll_interval = 100; // ms between two tests of the Ctrl-C flag and of the time

/// Runs a job in the child. No exception may leave: the child would continue as a second copy of the program.
[[noreturn]] void run_child(int pipe, pid_t parent, int i, const std::function<std::string(int)>& job) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1); // the parent ended before prctl()
  std::signal(SIGINT, SIG_IGN);      // a terminal sends Ctrl-C to all processes; the parent decides
  abandon_worker_threads();
  // Exit handlers that the parent registered wait for threads that a child does not have.
  on_exit(
      [](int status, void*) {
        std::fflush(nullptr);
        _exit(status);
      },
      nullptr);
  std::string message;
  try {
    forbid_children();
    message = returned + job(i);
  } catch (const std::exception& error) {
    message = threw + std::string(error.what());
  } catch (...) {
    message = threw + std::string("unknown exception");
  }
  std::cout.flush();
  std::fflush(nullptr); // what the job printed; the parent's output was flushed before the fork
  _exit(write_all(pipe, message) ? 0 : 1);
}

/// One child and the pipe from it. The destructor kills the child.
class Child {
public:
  Child(int number, const std::function<std::string(int)>& job) : number_(number) {
    int ends[2];
    require(pipe2(ends, O_CLOEXEC) == 0, "os.jobs.pipe", {{"reason", std::strerror(errno)}});
    std::cout.flush();
    std::fflush(nullptr);
    const pid_t parent = getpid();
    id_ = fork();
    if (id_ == 0) run_child(ends[1], parent, number, job);
    const int reason = errno;
    close(ends[1]);
    pipe_ = ends[0];
    if (id_ < 0) close(pipe_);
    require(id_ > 0, "os.jobs.fork", {{"reason", std::strerror(reason)}});
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (id_ > 0) end(true);
  }

  int pipe() const { return pipe_; }
  double seconds() const { return watch_.seconds(); }
  void give_notice() const { kill(id_, SIGUSR1); }

  /// Reads available output; false at its end.
  bool read_some() {
    char buffer[1 << 16];
    const ssize_t count = ::read(pipe_, buffer, sizeof buffer);
    if (count > 0) data_.append(buffer, count);
    return count > 0 || (count < 0 && errno == EINTR);
  }

  /// Waits for the child, which is about to end or is killed now because it is late or after a notice, and returns its
  /// result.
  JobEnd result(bool late, bool stopped) {
    const int status = end(late || stopped);
    JobEnd result{number_, "", {}};
    if (stopped || (WIFEXITED(status) && WEXITSTATUS(status) == to_be_continued))
      result.failure = Message("os.jobs.stopped");
    else if (late)
      result.failure = Message("os.jobs.time");
    else if (WIFSIGNALED(status))
      result.failure = Message("os.jobs.signal", {{"signal", WTERMSIG(status)}});
    else if (status != 0 || data_.empty())
      result.failure = Message("os.jobs.status", {{"status", WEXITSTATUS(status)}});
    else if (data_[0] == threw)
      result.failure = Message("os.jobs.threw", {{"error", data_.substr(1)}});
    else
      result.output = data_.substr(1);
    return result;
  }

private:
  int end(bool killed) {
    if (killed) kill(id_, SIGKILL);
    close(pipe_);
    int status = 0;
    while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    id_ = 0;
    return status;
  }

  int number_;
  pid_t id_ = 0;
  int pipe_ = -1;
  Stopwatch watch_;
  std::string data_;
};

/// Children that have output or have ended; waits for one, at most for a short time.
std::vector<pollfd> poll_children(const std::list<Child>& children) {
  std::vector<pollfd> pipes;
  for (const Child& child : children) pipes.push_back({child.pipe(), POLLIN, 0});
  if (poll(pipes.data(), pipes.size(), poll_interval) <= 0)
    for (pollfd& pipe : pipes) pipe.revents = 0;
  return pipes;
}

} // namespace

bool run_jobs(int count, const JobLimits& limits, const std::function<std::string(int)>& job,
              const std::function<void(const JobEnd&)>& done, const std::function<void(int)>& look) {
  const bool inside = !sandbox_folder().empty();
  require(!inside || sandbox_processes() > 0, "os.jobs.sandbox");
  require(limits.at_once >= 1, "os.jobs.at_once", {{"at_once", limits.at_once}});
  require(limits.seconds > 0, "os.jobs.seconds", {{"seconds", limits.seconds}});
  const int at_once = inside ? std::min(limits.at_once, sandbox_processes()) : limits.at_once;
  std::list<Child> children;
  std::optional<Stopwatch> since_notice;
  int next = 0;
  for (; (next < count && !since_notice) || !children.empty();) {
    while (next < count && static_cast<int>(children.size()) < at_once && !interrupted() && !notice_given())
      children.emplace_back(next++, job);
    if (notice_given() && !since_notice) {
      since_notice.emplace();
      for (const Child& child : children) child.give_notice();
    }
    const std::vector<pollfd> pipes = poll_children(children);
    if (interrupted()) {
      report_interrupt();
      return false;
    }
    if (look) look(static_cast<int>(children.size()));
    auto child = children.begin();
    for (const pollfd& pipe : pipes) {
      const bool ended = pipe.revents && !child->read_some();
      const bool stopped = !ended && since_notice && since_notice->seconds() > limits.grace;
      const bool late = !ended && child->seconds() > limits.seconds;
      if (!ended && !late && !stopped) {
        ++child;
        continue;
      }
      const JobEnd result = child->result(late, stopped);
      child = children.erase(child);
      done(result);
    }
  }
  return next == count;
}

} // namespace signorini
