#pragma once
// Messages of errors, and contents of SVG files.

#include "base/error.hpp"

#include <gtest/gtest.h>
#include <initializer_list>
#include <string>

namespace signorini::view {

/// The message of the Error that the action throws; "no error" when it throws none.
template <class Action> std::string message_of(Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// A color in the notation of an SVG: "#0072b2" is 0%, 44.7 %, 69.8 %.
inline std::string in_svg(const std::string& hex) {
  std::string parts;
  for (std::size_t i : {1, 3, 5}) {
    char digits[16];
    std::snprintf(digits, sizeof digits, "%f", 100 * std::stoi(hex.substr(i, 2), nullptr, 16) / 255.0);
    std::string part = digits;
    part.erase(part.find_last_not_of('0') + 1);
    if (part.back() == '.') part.pop_back();
    parts += (parts.empty() ? "" : ",") + part + "%";
  }
  return "rgb(" + parts + ")";
}

inline testing::AssertionResult holds(const std::string& text, std::initializer_list<std::string> parts) {
  for (const std::string& part : parts)
    if (text.find(part) == std::string::npos) return testing::AssertionFailure() << text;
  return testing::AssertionSuccess();
}

} // namespace signorini::view
