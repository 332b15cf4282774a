#pragma once
// What an Error says.

#include "base/error.hpp"

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

inline bool holds(const std::string& text, std::initializer_list<std::string> parts) {
  for (const std::string& part : parts)
    if (text.find(part) == std::string::npos) return false;
  return true;
}

} // namespace signorini::view
