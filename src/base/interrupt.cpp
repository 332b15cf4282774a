#include "base/interrupt.hpp"

#include <csignal>

namespace signorini {

namespace {

volatile std::sig_atomic_t flag = 0;
bool answered = false;

void on_interrupt(int signal) {
  if (flag) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  flag = 1;
}

} // namespace

void catch_interrupts() {
  std::signal(SIGINT, on_interrupt);
}
void request_interrupt() {
  flag = 1;
}
bool interrupted() {
  return flag != 0;
}
void answer_interrupt() {
  answered = true;
}
bool interrupt_answered() {
  return answered;
}
void clear_interrupt() {
  answered = false;
  flag = 0;
}

} // namespace signorini
