#include "repl/kernel/output.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <iostream>
#include <poll.h>
#include <stdexcept>
#include <thread>
#include <unistd.h>

namespace signorini::repl::kernel {

namespace {

constexpr int pipe_size = 1 << 20; // bytes
/// Pause between two messages: front ends drop output that comes in too many messages per second.
constexpr std::chrono::milliseconds pause(50);
constexpr int parent_interval = 1000; // ms between two tests whether the parent lives

/// Bytes at the end of a text that begin a UTF-8 character whose other bytes are missing.
std::size_t unfinished_bytes(const std::string& text) {
  for (std::size_t back = 1; back <= std::min<std::size_t>(3, text.size()); ++back) {
    const auto byte = static_cast<unsigned char>(text[text.size() - back]);
    if ((byte & 0xC0) == 0x80) continue;
    const std::size_t length = byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : byte >= 0xC0 ? 2 : 1;
    return length > back ? back : 0;
  }
  return 0;
}

/// The server that started this kernel (JPY_PARENT_PID), if it is the parent process: a kernel does not outlive it.
pid_t find_owner() {
  const char* id = std::getenv("JPY_PARENT_PID");
  return id && std::atoi(id) == getppid() ? getppid() : 0;
}

} // namespace

Output::Output(Publish publish)
    : publish_(std::move(publish)), streams_{Stream{"stdout", STDOUT_FILENO, -1, -1, -1},
                                             Stream{"stderr", STDERR_FILENO, -1, -1, -1}} {
  for (Stream& stream : streams_) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error(std::strerror(errno));
    stream.read_end = ends[0];
    stream.write_end = ends[1];
    fcntl(stream.read_end, F_SETFL, O_NONBLOCK);
    fcntl(stream.write_end, F_SETPIPE_SZ, pipe_size); // may be refused: then writers wait for the reader more often
    stream.original = fcntl(stream.descriptor, F_DUPFD_CLOEXEC, 3);
  }
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
}

void Output::start() {
  std::thread([this] { follow(); }).detach();
}

void Output::begin(nlohmann::json parent, bool silent) {
  const std::lock_guard lock(mutex_);
  send_available(true); // of a process that an earlier cell left running
  parent_ = std::move(parent);
  silent_ = silent;
  for (const Stream& stream : streams_) dup2(stream.write_end, stream.descriptor);
}

void Output::flush() {
  std::cout.flush();
  std::fflush(stdout);
  const std::lock_guard lock(mutex_);
  send_available(true);
}

void Output::end() {
  flush();
  const std::lock_guard lock(mutex_);
  for (const Stream& stream : streams_) dup2(stream.original, stream.descriptor);
}

void Output::send_available(bool all) {
  for (Stream& stream : streams_) {
    std::string text = std::move(stream.left);
    stream.left.clear();
    char buffer[1 << 16];
    ssize_t count = 0;
    while ((count = ::read(stream.read_end, buffer, sizeof buffer)) > 0 || (count < 0 && errno == EINTR))
      if (count > 0) text.append(buffer, count);
    if (!all) {
      const std::size_t finished = text.size() - unfinished_bytes(text);
      stream.left = text.substr(finished);
      text.resize(finished);
    }
    if (!text.empty() && !silent_) publish_(stream.name, text, parent_);
  }
}

/// Sends what comes while a cell runs.
void Output::follow() {
  const pid_t owner = find_owner();
  for (;;) {
    pollfd ready[] = {{streams_[0].read_end, POLLIN, 0}, {streams_[1].read_end, POLLIN, 0}};
    const int count = poll(ready, 2, owner ? parent_interval : -1);
    if (owner && getppid() != owner) kill(getpid(), SIGTERM);
    if (count <= 0) continue;
    {
      const std::lock_guard lock(mutex_);
      send_available(false);
    }
    std::this_thread::sleep_for(pause);
  }
}

} // namespace signorini::repl::kernel
