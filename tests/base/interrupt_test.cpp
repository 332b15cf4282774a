#include "base/interrupt.hpp"

#include <csignal>
#include <gtest/gtest.h>

namespace signorini {
namespace {

TEST(Interrupt, CtrlCRaisesAFlagThatStaysUntilItIsCleared) {
  catch_interrupts();
  EXPECT_FALSE(interrupted());
  std::raise(SIGINT);
  EXPECT_TRUE(interrupted());
  EXPECT_TRUE(interrupted());
  clear_interrupt();
  EXPECT_FALSE(interrupted());
}

TEST(Interrupt, ASecondCtrlCBeforeTheFirstWasSeenEndsTheProgram) {
  EXPECT_EXIT(
      {
        catch_interrupts();
        std::raise(SIGINT);
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
}

} // namespace
} // namespace signorini
