#include "messages.hpp"
#include "os/process.hpp"

#include <gtest/gtest.h>

namespace signorini {
namespace process_test {

std::string message_of(const std::vector<std::string>& words) {
  return test::message_of([&] { run_program(words); });
}

TEST(Process, PassesArgumentsUnchanged) {
  const std::string word = "a b; exit 7 'c' \"$HOME\"";
  EXPECT_EQ(message_of({"sh", "-c", "test ${#1} = " + std::to_string(word.size()), "x", word}), "no error");
  EXPECT_NE(message_of({"sh", "-c", "test ${#1} = 1", "x", word}), "no error");
  EXPECT_EQ(message_of({"test", word, "=", word}), "no error");
}

TEST(Process, ReportsTheOutputOfAFailedProgram) {
  EXPECT_EQ(message_of({"sh", "-c", "echo no disk; exit 3"}), "os.process.failed: program = sh, output = no disk\n");
  EXPECT_TRUE(
      test::holds(message_of({"no-such-program-anywhere"}), {"os.process.start: program = no-such-program-anywhere"}));
  EXPECT_TRUE(has_program("sh"));
  EXPECT_FALSE(has_program("no-such-program-anywhere"));
}

} // namespace process_test
} // namespace signorini
