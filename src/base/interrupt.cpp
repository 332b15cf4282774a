#include "base/interrupt.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <unistd.h>

namespace signorini {

namespace {

volatile std::sig_atomic_t flag = 0, iterating = 0, survives = 0, descriptor = -1;
bool answered = false;

/// Calls only async-signal-safe functions. A progress bar may occupy the line.
void acknowledge() {
  const char* words = survives ? "\r\33[Kinterrupting after this iteration\n"
                               : "\r\33[Kinterrupting after this iteration; a second Ctrl-C ends the program\n";
  const int error = errno;
  [[maybe_unused]] const auto written = ::write(descriptor, words, std::strlen(words));
  errno = error;
}

void on_interrupt(int signal) {
  if (flag && !survives) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  if (iterating && descriptor >= 0) acknowledge();
  flag = 1;
}

} // namespace

void catch_interrupts() {
  std::signal(SIGINT, on_interrupt);
}
void survive_interrupts() {
  survives = 1;
}
void acknowledge_interrupts(int file) {
  descriptor = file;
}
Iteration::Iteration() {
  iterating = 1;
}
Iteration::~Iteration() {
  iterating = 0;
}
void interrupt() {
  flag = 1;
}
bool interrupted() {
  return flag != 0;
}
void report_interrupt() {
  answered = true;
}
bool interrupt_reported() {
  return answered;
}
void clear_interrupt() {
  answered = false;
  flag = 0;
}

} // namespace signorini
