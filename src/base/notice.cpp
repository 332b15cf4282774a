#include "base/notice.hpp"

#include <csignal>

namespace signorini {

namespace {

volatile std::sig_atomic_t noticed = 0;

} // namespace

void catch_notice() {
  std::signal(SIGUSR1, [](int) { noticed = 1; });
}

bool notice_given() {
  return noticed != 0;
}

} // namespace signorini
