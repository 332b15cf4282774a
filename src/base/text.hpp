#pragma once
// Concatenation of texts: contents of files, names, wording.

#include <initializer_list>
#include <ostream>
#include <string>

namespace signorini {

/// A reference to a part of a text: anything that can be streamed. The parts are joined in one function: with streams
/// in each of hundreds of callers, this was a tenth of the program's code.
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

/// Concatenates the parts; numbers with at most ten significant digits.
template <class... Parts> std::string text(const Parts&... parts) {
  return joined({TextPart(parts)...});
}

} // namespace signorini
