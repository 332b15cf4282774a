#include "os/limits.hpp"

#include "base/error.hpp"
#include "os/interrupt.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>
#include <string_view>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

namespace signorini {

namespace {

constexpr double least_reserve = 64 << 20; // bytes
std::string limit;
int reserves = 0;

/// Bytes that RLIMIT_DATA counts now; 0 if unknown.
double data_in_use() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmData:")) return 1024 * std::stod(line.substr(7));
  return 0;
}

/// Uses the hard limit, which contains the reserve, or the part below it that is without.
void use_reserve(bool used) {
  rlimit data{};
  if (getrlimit(RLIMIT_DATA, &data) != 0) return;
  const auto all = static_cast<double>(data.rlim_max), reserve = std::max(all / 17, least_reserve);
  data.rlim_cur = used ? data.rlim_max : static_cast<rlim_t>(all - reserve);
  setrlimit(RLIMIT_DATA, &data);
}

constexpr int status_of_time_limit = 124; // that of timeout(1)

std::string written_time;
double limited_seconds = 0;
void (*when_over)() = nullptr;
volatile std::sig_atomic_t over = 0;

void set_timer(double seconds) {
  const double whole = std::floor(seconds);
  const itimerval time{{0, 0}, {static_cast<time_t>(whole), static_cast<suseconds_t>(1e6 * (seconds - whole))}};
  setitimer(ITIMER_REAL, &time, nullptr);
}

/// Calls only async-signal-safe functions.
void on_alarm(int) {
  if (over) {
    constexpr std::string_view words =
        "\r\33[Ksignorini: the time limit given by --time is over, and the run did not stop\n";
    const std::string_view shown = isatty(STDERR_FILENO) ? words : words.substr(words.find("sig"));
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, shown.data(), shown.size());
    _exit(status_of_time_limit);
  }
  over = 1;
  set_timer(std::max(2.0, limited_seconds / 10));
  interrupt();
  when_over();
}

} // namespace

void limit_memory(double bytes, const std::string& written) {
  const double used = data_in_use();
  require(bytes > used, "os.limits.memory_used", {{"limit", written}, {"used", used / (1 << 20)}});
  const auto all = static_cast<rlim_t>(bytes + std::max(bytes / 16, least_reserve));
  const rlimit data{all, all};
  require(setrlimit(RLIMIT_DATA, &data) == 0, "os.limits.memory",
          {{"limit", written}, {"reason", std::strerror(errno)}});
  limit = written;
  use_reserve(false);
}

const std::string& memory_limit() {
  return limit;
}

MemoryReserve::MemoryReserve() {
  if (!limit.empty() && reserves++ == 0) use_reserve(true);
}

MemoryReserve::~MemoryReserve() {
  if (!limit.empty() && --reserves == 0) use_reserve(false);
}

void demand_memory(double bytes) {
  if (limit.empty()) return;
  // An untouched mapping: it is counted, but the system does not provide it.
  const auto size = static_cast<std::size_t>(bytes);
  void* tried = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (tried == MAP_FAILED) throw std::bad_alloc();
  ::munmap(tried, size);
}

void limit_time(double seconds, const std::string& written, void (*over)()) {
  limited_seconds = seconds;
  written_time = written;
  when_over = over;
  std::signal(SIGALRM, on_alarm);
}

void start_time_limit() {
  over = 0;
  if (limited_seconds > 0) set_timer(limited_seconds);
}

void stop_time_limit() {
  if (limited_seconds > 0) set_timer(0);
}

const std::string& time_limit() {
  return written_time;
}

bool out_of_time() {
  return over != 0;
}

} // namespace signorini
