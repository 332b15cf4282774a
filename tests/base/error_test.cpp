#include "base/eigen.hpp"
#include "base/error.hpp"

#include <array>
#include <gtest/gtest.h>

namespace signorini {
namespace error_test {

TEST(Text, JoinsPartsAndKeepsTenDigitsOfNumbers) {
  EXPECT_EQ(text("E = ", 0.1, ", n = ", 3), "E = 0.1, n = 3");
  EXPECT_EQ(text(1234567.25), "1234567.25");
}

TEST(Error, RequireThrowsOnlyOnFailure) {
  EXPECT_NO_THROW(require(true, "test.error.never_shown"));
  try {
    require(false, "test.error.bound", {{"nu", 0.7}, {"count", 3}});
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.message().code, "test.error.bound");
    EXPECT_STREQ(error.what(), "test.error.bound: nu = 0.7, count = 3");
  }
}

TEST(Message, HoldsDataOfAllTypesByName) {
  const std::vector<std::string> names{"a", "b"};
  const Message part("test.message.part", {{"x", 1e-9}}), nothing;
  const Message message("test.message.all", {{"count", std::size_t{3}},
                                             {"text", std::string_view("t")},
                                             {"point", Vec<2>(1, 2)},
                                             {"range", std::array{0.5, 2.0}},
                                             {"names", names},
                                             {"part", part},
                                             {"nothing", nothing}});
  EXPECT_EQ(bare_text(message), "test.message.all: count = 3, text = t, point = (1, 2), range = (0.5, 2), "
                                "names = (a, b), part = (test.message.part: x = 1e-09), nothing = ()");
  EXPECT_EQ(std::get<long long>(message.data[0].second), 3);
  EXPECT_EQ(std::get<std::vector<Message>>(message.data[5].second).front().code, "test.message.part");
}

} // namespace error_test
} // namespace signorini
