#include "base/error.hpp"
#include "os/process.hpp"

#include <gtest/gtest.h>

namespace signorini {
namespace process_test {

std::string message_of(const std::vector<std::string>& words) {
  try {
    run_program(words);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Process, PassesArgumentsUnchanged) {
  const std::string word = "a b; exit 7 'c' \"$HOME\"";
  EXPECT_EQ(message_of({"sh", "-c", "test ${#1} = " + std::to_string(word.size()), "x", word}), "");
  EXPECT_NE(message_of({"sh", "-c", "test ${#1} = 1", "x", word}), "");
  EXPECT_EQ(message_of({"test", word, "=", word}), "");
}

TEST(Process, ReportsTheOutputOfAFailedProgram) {
  EXPECT_EQ(message_of({"sh", "-c", "echo no disk; exit 3"}), "os.process.failed: program = sh, output = no disk\n");
  EXPECT_NE(message_of({"no-such-program-anywhere"}).find("os.process.start: program = no-such-program-anywhere"),
            std::string::npos);
  EXPECT_TRUE(has_program("sh"));
  EXPECT_FALSE(has_program("no-such-program-anywhere"));
}

} // namespace process_test
} // namespace signorini
