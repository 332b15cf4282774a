// Base64, against the test vectors of RFC 4648.

#include "base/base64.hpp"

#include <gtest/gtest.h>

namespace signorini::base64_test {
namespace {

TEST(Base64, EncodesTheTestVectorsOfTheStandard) {
  const char* expected[][2] = {{"", ""},
                               {"f", "Zg=="},
                               {"fo", "Zm8="},
                               {"foo", "Zm9v"},
                               {"foob", "Zm9vYg=="},
                               {"fooba", "Zm9vYmE="},
                               {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, code] : expected) EXPECT_EQ(base64(bytes), code);
}

TEST(Base64, EncodesBytesAboveAsciiAndZeros) {
  EXPECT_EQ(base64(std::string("\0\xff\xfe", 3)), "AP/+");
}

} // namespace
} // namespace signorini::base64_test
