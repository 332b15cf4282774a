#pragma once
// Texts put together from parts: what files hold, names, the words of bind.

#include <initializer_list>
#include <ostream>
#include <string>

namespace signorini {

/// A reference to a part of a text, which is anything that can be streamed. Texts are put together behind it in one
/// place: there are hundreds, and streams in each were a tenth of the program's text.
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

/// The parts one behind the other; numbers with enough digits to recognize them.
template <class... Parts> std::string text(const Parts&... parts) {
  return joined({TextPart(parts)...});
}

} // namespace signorini
