#include "os/timer.hpp"

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

namespace signorini {
namespace timer_test {

TEST(Timer, AddsTheTimesOfItsScopes) {
  double account = 1;
  {
    ScopedTimer timer(account);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const double once = account;
  EXPECT_GE(once, 1.005);
  { ScopedTimer timer(account); }
  EXPECT_GE(account, once);
  const double twice = account;
  { ScopedTimer timer(nullptr); } // no account
  EXPECT_EQ(account, twice);
}

} // namespace timer_test
} // namespace signorini
