#pragma once
// Messages of errors.

#include "base/error.hpp"

#include <gtest/gtest.h>
#include <initializer_list>
#include <string>

namespace signorini::test {

/// The message of the Error that the action throws; "no error" when it throws none.
template <class Action> std::string message_of(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// True if a text contains all the parts.
inline testing::AssertionResult holds(const std::string& text, std::initializer_list<std::string> parts) {
  for (const std::string& part : parts)
    if (text.find(part) == std::string::npos) return testing::AssertionFailure() << text;
  return testing::AssertionSuccess();
}

} // namespace signorini::test
