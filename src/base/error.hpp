#pragma once
// Errors that a user can act on. All input is checked by require() in the modules left of bind.

#include "base/message.hpp"
#include "base/text.hpp"

#include <stdexcept>

namespace signorini {

/// Invalid input or a failure that the user must know of. The message holds a code and data, no sentences; bind words
/// it, what() returns the code and the data.
class Error : public std::runtime_error {
public:
  explicit Error(Message message) : runtime_error(bare_text(message)), message_(std::move(message)) {}

  const Message& message() const { return message_; }

private:
  Message message_;
};

[[noreturn]] void fail(const char* code, std::initializer_list<Datum> data = {});

/// Throws Error with this message unless `ok`; the message is built only on failure.
inline void require(bool ok, const char* code, std::initializer_list<Datum> data = {}) {
  if (!ok) [[unlikely]]
    fail(code, data);
}

} // namespace signorini
