#include "os/interrupt.hpp"

#include <csignal>
#include <cstdlib>
#include <gtest/gtest.h>
#include <iostream>
#include <unistd.h>

namespace signorini {
namespace interrupt_test {

TEST(Interrupt, CtrlCSetsAFlagUntilItIsCleared) {
  catch_interrupts();
  EXPECT_FALSE(interrupted());
  std::raise(SIGINT);
  EXPECT_TRUE(interrupted());
  EXPECT_TRUE(interrupted());
  clear_interrupt();
  EXPECT_FALSE(interrupted());
}

TEST(Interrupt, SecondUnseenCtrlCEndsTheProgram) {
  EXPECT_EXIT(
      {
        catch_interrupts();
        std::raise(SIGINT);
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
}

TEST(Interrupt, SurvivesAnyNumberOfCtrlC) {
  EXPECT_EXIT(
      {
        catch_interrupts();
        survive_interrupts();
        for (int k = 0; k < 3; ++k) std::raise(SIGINT);
        std::exit(interrupted() ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

TEST(Interrupt, IsAcknowledgedImmediatelyDuringAnIteration) {
  EXPECT_EXIT(
      {
        catch_interrupts();
        survive_interrupts();
        acknowledge_interrupts(STDERR_FILENO);
        {
          const Iteration iteration;
          std::raise(SIGINT);
          std::cerr << "the rest of the iteration\n";
        }
        std::raise(SIGINT); // no iteration is running that would have to end first
        std::exit(0);
      },
      testing::ExitedWithCode(0), "^\r.\\[Kinterrupting after this iteration\nthe rest of the iteration\n$");
}

TEST(Interrupt, AcknowledgementNamesTheFactorizationThatRuns) {
  EXPECT_EXIT(
      {
        catch_interrupts();
        acknowledge_interrupts(STDERR_FILENO);
        const Iteration iteration;
        const Factorization factorization(123456);
        std::raise(SIGINT);
        std::exit(0);
      },
      testing::ExitedWithCode(0),
      "^\r.\\[Kinterrupting after this iteration, in which the factorization of 123456 unknowns has run for [0-9]+ s; "
      "a second Ctrl-C ends the program\n$");
}

} // namespace interrupt_test
} // namespace signorini
