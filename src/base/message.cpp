#include "base/message.hpp"

#include <sstream>

namespace signorini {

namespace {

struct Bare {
  std::ostream& out;

  template <class T> void operator()(const T& value) const { out << value; }
  void operator()(const Message& message) const { out << bare_text(message); }
  template <class T> void operator()(const std::vector<T>& list) const {
    const char* before = "(";
    for (const T& value : list) {
      out << std::exchange(before, ", ");
      (*this)(value);
    }
    out << (list.empty() ? "()" : ")");
  }
};

} // namespace

Value Datum::copied_text(const void* text) {
  return static_cast<const char*>(text);
}

std::pair<std::string, Value> Datum::pair() const {
  return {name_, take_(value_)};
}

Message::Message() = default;
Message::Message(const Message& other) = default;
Message::Message(Message&& other) noexcept = default;
Message& Message::operator=(const Message& other) = default;
Message& Message::operator=(Message&& other) noexcept = default;
Message::~Message() = default;

Message::Message(const char* code, std::initializer_list<Datum> values) : code(code) {
  data.reserve(values.size());
  for (const Datum& datum : values) data.push_back(datum.pair());
}

std::string bare_text(const Message& message) {
  std::ostringstream out;
  out << message.code;
  const char* before = ": ";
  for (const auto& [name, value] : message.data) {
    out << std::exchange(before, ", ") << name << " = ";
    std::visit(Bare{out}, value);
  }
  return out.str();
}

} // namespace signorini
