#include "exchange/text.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace signorini::exchange {

namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

} // namespace

std::string digits(double value) {
  std::array<char, 32> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

TextReader::TextReader(std::string file, std::string_view text, int line, bool comments)
    : file_(std::move(file)), text_(text), line_(line), taken_line_(line), comments_(comments) {}

void TextReader::skip() {
  while (place_ < text_.size()) {
    if (comments_ && text_[place_] == '#')
      while (place_ < text_.size() && text_[place_] != '\n') ++place_;
    else if (is_blank(text_[place_]))
      line_ += text_[place_++] == '\n';
    else
      return;
  }
}

bool TextReader::at_end() {
  skip();
  return place_ == text_.size();
}

std::string_view TextReader::peek() {
  skip();
  std::size_t end = place_;
  while (end < text_.size() && !is_blank(text_[end]) && !(comments_ && text_[end] == '#')) ++end;
  return text_.substr(place_, end - place_);
}

std::string_view TextReader::word(const char* expected) {
  const std::string_view next = peek();
  if (next.empty()) wrong("expected ", expected, ", but the file ends");
  taken_line_ = line_;
  place_ += next.size();
  return next;
}

void TextReader::keyword(std::string_view wanted) {
  const std::string_view came = word(text("'", wanted, "'").c_str());
  if (came != wanted) wrong("expected '", wanted, "', got '", came, "'");
}

double TextReader::number(const char* expected) {
  const std::string_view came = word(expected);
  // Other programs put a + in front.
  const char* begin = came.data() + (came.front() == '+' ? 1 : 0);
  double value = 0;
  const auto [end, error] = std::from_chars(begin, came.data() + came.size(), value);
  if (error != std::errc() || end != came.data() + came.size() || !std::isfinite(value))
    wrong("expected ", expected, ", got '", came, "'");
  return value;
}

int TextReader::integer(const char* expected, int low, int high) {
  const std::string_view came = word(expected);
  int value = 0;
  const auto [end, error] = std::from_chars(came.data(), came.data() + came.size(), value);
  if (error != std::errc() || end != came.data() + came.size() || value < low || value > high)
    wrong("expected ", expected, " (a whole number from ", low, " to ", high, "), got '", came, "'");
  return value;
}

std::string_view TextReader::rest_of_line() {
  const std::size_t begin = place_;
  while (place_ < text_.size() && text_[place_] != '\n') ++place_;
  return text_.substr(begin, place_ - begin);
}

KnotVector read_knots(TextReader& from, int degree, int functions) {
  std::vector<double> knots; // not reserved: a wrong file may claim any number
  while (static_cast<int>(knots.size()) < functions + degree + 1) knots.push_back(from.number("a knot"));
  return placed(from.file(), from.line(), [&] { return KnotVector(degree, std::move(knots)); });
}

} // namespace signorini::exchange
