#pragma once
// Messages of reports and diagnoses as text for tests: code and data.

#include "base/message.hpp"

namespace signorini {

inline std::string text_of(const std::vector<Message>& messages) {
  std::string all;
  for (const Message& message : messages) all += (all.empty() ? "" : "; ") + bare_text(message);
  return all;
}

} // namespace signorini
