#include "repl/standard_streams.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace signorini::repl {

namespace {

void check_output() {
  const bool lost = std::ferror(stdout) != 0, flushed = std::fflush(stdout) == 0;
  if (!lost && flushed) return;
  std::fprintf(stderr, "signorini: the output could not be written%s%s. Hint: what was printed is incomplete\n",
               flushed ? "" : ": ", flushed ? "" : std::strerror(errno));
  std::_Exit(EXIT_FAILURE);
}

} // namespace

void open_standard_streams() {
  // open() returns the lowest free number.
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0 && open("/dev/null", O_RDWR) != stream) std::abort();
}

void report_lost_output() {
  std::signal(SIGXFSZ, SIG_IGN);
  std::atexit(check_output);
}

} // namespace signorini::repl
