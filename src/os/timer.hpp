#pragma once
// Wall-clock times: a Stopwatch measures, a ScopedTimer adds the time of its scope to an account.

#include <chrono>
#include <optional>

namespace signorini {

class Stopwatch {
public:
  /// Seconds since construction.
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

class ScopedTimer {
public:
  explicit ScopedTimer(double& account) : ScopedTimer(&account) {}
  /// Null: the clock is not read.
  explicit ScopedTimer(double* account) : account_(account) {
    if (account_) watch_.emplace();
  }
  ~ScopedTimer() {
    if (account_) *account_ += watch_->seconds();
  }
  ScopedTimer(const ScopedTimer&) = delete;
  ScopedTimer& operator=(const ScopedTimer&) = delete;

private:
  double* account_;
  std::optional<Stopwatch> watch_;
};

} // namespace signorini
