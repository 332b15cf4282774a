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

void fail_at(const std::string& file, int line, const Message& problem) {
  fail("exchange.file.at_line", {{"file", file}, {"line", line}, {"problem", problem}});
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

std::string_view TextReader::word(const char* code, std::initializer_list<Datum> data) {
  const std::string_view next = peek();
  if (next.empty()) wrong("exchange.text.end", {{"expected", Message(code, data)}});
  taken_line_ = line_;
  place_ += next.size();
  return next;
}

void TextReader::keyword(std::string_view wanted) {
  const std::string_view came = word("exchange.expected.word", {{"word", wanted}});
  if (came != wanted) wrong("exchange.text.keyword", {{"expected", wanted}, {"word", came}});
}

double TextReader::number(const char* code) {
  const std::string_view came = word(code);
  // Some programs write a leading +.
  const char* begin = came.data() + (came.front() == '+' ? 1 : 0);
  double value = 0;
  const auto [end, error] = std::from_chars(begin, came.data() + came.size(), value);
  if (error != std::errc() || end != came.data() + came.size() || !std::isfinite(value))
    wrong("exchange.text.number", {{"expected", Message(code)}, {"word", came}});
  return value;
}

int TextReader::integer(int low, int high, const char* code, std::initializer_list<Datum> data) {
  const std::string_view came = word(code, data);
  int value = 0;
  const auto [end, error] = std::from_chars(came.data(), came.data() + came.size(), value);
  if (error != std::errc() || end != came.data() + came.size() || value < low || value > high)
    wrong("exchange.text.integer", {{"expected", Message(code, data)}, {"low", low}, {"high", high}, {"word", came}});
  return value;
}

void TextReader::expect_numbers(long count) const {
  constexpr long harmless = 10'000;                                   // readers say better what is missing
  const auto most = static_cast<long>(text_.size() - place_ + 1) / 2; // a digit and a blank each
  if (count > harmless && count > most) wrong("exchange.text.too_short", {{"count", count}});
}

void TextReader::wrong(const char* code, std::initializer_list<Datum> data) const {
  fail_at(file_, taken_line_, Message(code, data));
}

std::string_view TextReader::rest_of_line() {
  const std::size_t begin = place_;
  while (place_ < text_.size() && text_[place_] != '\n') ++place_;
  return text_.substr(begin, place_ - begin);
}

KnotVector read_knots(TextReader& from, int degree, int functions) {
  std::vector<double> knots; // not reserved: a damaged file may contain any number
  while (static_cast<int>(knots.size()) < functions + degree + 1)
    knots.push_back(from.number("exchange.expected.knot"));
  return placed(from.file(), from.line(), [&] { return KnotVector(degree, std::move(knots)); });
}

} // namespace signorini::exchange
