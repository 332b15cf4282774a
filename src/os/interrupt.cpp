#include "os/interrupt.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <ctime>
#include <string_view>
#include <unistd.h>

namespace signorini {

namespace {

// Signal handlers write them on any thread: such atomics are as safe there as in threads.
std::atomic<bool> flag = false, iterating = false, survives = false;
std::atomic<int> descriptor = -1, factored = 0;
std::atomic<long> factoring_since = 0; // seconds of now()
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free &&
              std::atomic<long>::is_always_lock_free);
bool answered = false;

/// A line of text in memory of its own, for signal handlers.
class Line {
public:
  void add(std::string_view words) {
    const std::size_t count = std::min(words.size(), sizeof letters_ - size_);
    std::copy_n(words.data(), count, letters_ + size_);
    size_ += count;
  }
  void add(long number) {
    char digits[20];
    const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
    add({digits, static_cast<std::size_t>(end - digits)});
  }
  std::string_view text() const { return {letters_, size_}; }

private:
  char letters_[256];
  std::size_t size_ = 0;
};

long now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec;
}

/// Calls only async-signal-safe functions. A progress bar may occupy the line.
void acknowledge() {
  const int error = errno;
  Line line;
  line.add("\r\33[Kinterrupting after this iteration");
  if (factored > 0) {
    line.add(", in which the factorization of ");
    line.add(static_cast<long>(factored));
    line.add(" unknowns has run for ");
    line.add(now() - factoring_since);
    line.add(" s");
  }
  line.add(survives ? "\n" : "; a second Ctrl-C ends the program\n");
  [[maybe_unused]] const auto written = ::write(descriptor, line.text().data(), line.text().size());
  errno = error;
}

void on_interrupt(int signal) {
  if (flag && !survives) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  if (iterating && descriptor >= 0) acknowledge();
  flag = true;
}

} // namespace

void catch_interrupts() {
  std::signal(SIGINT, on_interrupt);
}
void survive_interrupts() {
  survives = true;
}
void acknowledge_interrupts(int file) {
  descriptor = file;
}
Iteration::Iteration() {
  iterating = true;
}
Iteration::~Iteration() {
  iterating = false;
}
Factorization::Factorization(int unknowns) {
  factoring_since = now();
  factored = unknowns;
}
Factorization::~Factorization() {
  factored = 0;
}
void interrupt() {
  flag = true;
}
bool interrupted() {
  return flag;
}
void report_interrupt() {
  answered = true;
}
bool interrupt_reported() {
  return answered;
}
void clear_interrupt() {
  answered = false;
  flag = false;
}

} // namespace signorini
