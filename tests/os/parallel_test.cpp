#include "os/parallel.hpp"

#include "base/error.hpp"

#include <atomic>
#include <cstdlib>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

namespace signorini {
namespace parallel_test {

/// Restores one thread at the end of a test.
struct Workers {
  explicit Workers(int threads) { set_worker_threads(threads); }
  ~Workers() { set_worker_threads(1); }
};

TEST(Parallel, RunsEveryTaskOnceForAnyNumberOfThreads) {
  for (int threads : {1, 2, 3, 8}) {
    const Workers workers(threads);
    EXPECT_EQ(worker_threads(), threads);
    for (int round = 0; round < 2000; ++round) {
      const int count = round % 7;
      std::vector<int> runs(static_cast<std::size_t>(count), 0);
      parallel(count, [&](int i) { ++runs[i]; });
      for (int n : runs) ASSERT_EQ(n, 1) << threads << " threads, round " << round;
    }
  }
}

TEST(Parallel, UsesTheOtherThreads) {
  const Workers workers(2);
  // Each of the two tasks waits for the other: they end only if they run in parallel.
  std::atomic<int> present = 0;
  parallel(2, [&](int) {
    ++present;
    while (present < 2) {
    }
  });
  EXPECT_EQ(present, 2);
}

TEST(Parallel, RunsEveryTaskOnceAlsoInCallsFromTasks) {
  const Workers workers(3);
  for (int round = 0; round < 200; ++round) {
    std::vector<int> runs(40, 0);
    parallel(8, [&](int i) { parallel(5, [&](int j) { ++runs[5 * i + j]; }); });
    EXPECT_EQ(runs, std::vector<int>(40, 1)) << "round " << round;
  }
}

/// Ends the process with status 0 if check_threads() reports that there are none. The superuser has no limit.
[[noreturn]] void check_without_permission() {
  constexpr uid_t nobody = 65534;
  const rlimit none{1, 1};
  if (::setrlimit(RLIMIT_NPROC, &none) != 0 || (::getuid() == 0 && ::setuid(nobody) != 0)) std::_Exit(2);
  try {
    check_threads();
  } catch (const Error& error) {
    std::_Exit(std::string(error.what()).starts_with("os.threads.none") ? 0 : 1);
  }
  std::_Exit(3);
}

TEST(Parallel, ReportsThatNoThreadsAreStarted) {
  EXPECT_NO_THROW(check_threads());
  EXPECT_EXIT(check_without_permission(), testing::ExitedWithCode(0), "");
}

TEST(Parallel, ThrowsTheFirstErrorAfterAllTasksAreDone) {
  for (int threads : {1, 2}) {
    const Workers workers(threads);
    std::atomic<int> done = 0;
    const auto run = [&] {
      parallel(6, [&](int i) {
        if (i == 2 || i == 4) throw std::runtime_error(std::to_string(i));
        ++done;
      });
    };
    try {
      run();
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "2");
    }
    if (threads > 1) {
      EXPECT_EQ(done, 4);
    }
    int sum = 0;
    parallel(1, [&](int) { ++sum; });
    EXPECT_EQ(sum, 1);
  }
}

} // namespace parallel_test
} // namespace signorini
