#pragma once
// Errors that a user can act on. Every check of input in the program goes through require().

#include <initializer_list>
#include <ostream>
#include <stdexcept>
#include <string>

namespace signorini {

/// A wrong input or a state the user must know of; the message names what came, what was expected and the cure.
class Error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// A reference to a part of a message, which is anything that can be streamed. Messages are put together behind it in
/// one place: there are hundreds, and streams in each were a tenth of the program's text.
class TextPart {
public:
  template <class T>
  TextPart(const T& value)
      : value_(&value), put_([](std::ostream& out, const void* value) { out << *static_cast<const T*>(value); }) {}
  TextPart(const char* words)
      : value_(words), put_([](std::ostream& out, const void* value) { out << static_cast<const char*>(value); }) {}

  friend std::ostream& operator<<(std::ostream& out, const TextPart& part) {
    part.put_(out, part.value_);
    return out;
  }

private:
  const void* value_;
  void (*put_)(std::ostream& out, const void* value);
};

std::string joined(std::initializer_list<TextPart> parts);
[[noreturn]] void fail_with(std::initializer_list<TextPart> parts);

/// The parts one behind the other; numbers with enough digits to recognise them.
template <class... Parts> std::string text(const Parts&... parts) {
  return joined({TextPart(parts)...});
}

template <class... Parts> [[noreturn]] void fail(const Parts&... parts) {
  fail_with({TextPart(parts)...});
}

/// Throws Error with the joined parts unless `ok`; the message is only built on failure.
template <class... Parts> void require(bool ok, const Parts&... parts) {
  if (!ok) [[unlikely]]
    fail_with({TextPart(parts)...});
}

} // namespace signorini
