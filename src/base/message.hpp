#pragma once
// Messages without words: a code and named values. bind turns them into sentences.

#include <concepts>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace signorini {

struct Message;

/// An integer, a number, a text, several numbers (a point, a range) or texts, or nested messages.
using Value =
    std::variant<long long, double, std::string, std::vector<double>, std::vector<std::string>, std::vector<Message>>;

/// A named value where a message is made. It refers to the value, so that nothing is copied unless a message results.
class Datum {
public:
  template <class T>
  Datum(const char* name, const T& value)
      : name_(name), value_(&value), take_([](const void* value) { return copied(*static_cast<const T*>(value)); }) {}
  Datum(const char* name, const char* text) : name_(name), value_(text), take_(copied_text) {}

  std::pair<std::string, Value> pair() const;

private:
  static Value copied_text(const void* text);
  template <class T> static Value copied(const T& value);

  const char* name_;
  const void* value_;
  Value (*take_)(const void* value);
};

/// `code`: module, subject and problem, "nurbs.arc.turn". A message without a code is empty; as data of another message
/// it is left out of the sentence.
struct Message {
  Message();
  explicit Message(const char* code, std::initializer_list<Datum> values = {});
  // Defined in message.cpp: copying the data is long code, and messages are copied in many places.
  Message(const Message& other);
  Message(Message&& other) noexcept;
  Message& operator=(const Message& other);
  Message& operator=(Message&& other) noexcept;
  ~Message();

  std::string code;
  std::vector<std::pair<std::string, Value>> data;
};

/// Code and data, for callers without access to the wording: "nurbs.arc.turn: start = 0, stop = 400".
std::string bare_text(const Message& message);

template <class T> Value Datum::copied(const T& value) {
  if constexpr (std::integral<T>) {
    return static_cast<long long>(value);
  } else if constexpr (std::floating_point<T>) {
    return static_cast<double>(value);
  } else if constexpr (std::same_as<T, Message>) {
    return value.code.empty() ? std::vector<Message>() : std::vector<Message>{value};
  } else if constexpr (std::convertible_to<T, std::string_view>) {
    return std::string(std::string_view(value));
  } else if constexpr (std::constructible_from<Value, T>) {
    return value;
  } else {
    return std::vector<double>(value.begin(), value.end());
  }
}

} // namespace signorini
