#include "base/error.hpp"

#include <gtest/gtest.h>

namespace signorini {
namespace error_test {

TEST(Error, PartsAreJoinedAndNumbersStayRecognisable) {
  EXPECT_EQ(text("E = ", 0.1, ", n = ", 3), "E = 0.1, n = 3");
  EXPECT_EQ(text(1234567.25), "1234567.25");
}

TEST(Error, RequireThrowsTheJoinedMessageOnlyWhenItDoesNotHold) {
  EXPECT_NO_THROW(require(true, "never shown"));
  try {
    require(false, "nu must be below ", 0.5, ", got ", 0.7);
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "nu must be below 0.5, got 0.7");
  }
}

} // namespace error_test
} // namespace signorini
