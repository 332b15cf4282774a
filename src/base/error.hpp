#pragma once
// Errors that a user can act on. Every check of input left of bind goes through require().

#include "base/message.hpp"
#include "base/text.hpp"

#include <stdexcept>

namespace signorini {

/// A wrong input or a state the user must know of. The message says in code and data what came and what was expected;
/// bind makes a sentence of it, what() has no words.
class Error : public std::runtime_error {
public:
  explicit Error(Message message) : runtime_error(bare_text(message)), message_(std::move(message)) {}

  const Message& message() const { return message_; }

private:
  Message message_;
};

[[noreturn]] void fail(const char* code, std::initializer_list<Datum> data = {});

/// Throws Error with this message unless `ok`; the message is only built on failure.
inline void require(bool ok, const char* code, std::initializer_list<Datum> data = {}) {
  if (!ok) [[unlikely]]
    fail(code, data);
}

} // namespace signorini
