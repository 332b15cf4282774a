#pragma once
// Tokens of text files with the line numbers for messages, and readers and writers of the individual formats.

#include "base/error.hpp"
#include "exchange/exchange.hpp"
#include "nurbs/patch.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace signorini::exchange {

using nurbs::KnotVector;

/// The shortest decimal number that reads back with the same bits.
std::string digits(double value);
/// Numbers separated by spaces, and a line break.
template <class Values> std::string line_of(const Values& values) {
  std::string result;
  for (const auto& value : values) result += (result.empty() ? "" : " ") + digits(value);
  return result + "\n";
}

/// Throws Error with file, line and problem.
[[noreturn]] void fail_at(const std::string& file, int line, const Message& problem);

/// Reads a text token by token.
class TextReader {
public:
  /// `file` is the name in messages, `line` the number of the text's first line. If `comments`, the rest of a line
  /// after # is skipped.
  TextReader(std::string file, std::string_view text, int line = 1, bool comments = true);

  /// True if all words were read.
  bool at_end();
  /// The next word, without consuming it; empty at the end.
  std::string_view peek();
  /// Reads the next word. Code and data name what is expected: "exchange.expected.knot".
  std::string_view word(const char* code, std::initializer_list<Datum> data = {});
  /// Reads the next word, which must be `word`.
  void keyword(std::string_view word);
  double number(const char* code);
  int integer(int low, int high, const char* code, std::initializer_list<Datum> data = {});
  /// Throws Error if the text is too short for so many numbers, before memory is taken for them.
  void expect_numbers(long count) const;
  /// Reads the rest of the current line.
  std::string_view rest_of_line();
  /// Throws Error at the line of the last word read.
  [[noreturn]] void wrong(const char* code, std::initializer_list<Datum> data = {}) const;
  int line() const { return taken_line_; }
  const std::string& file() const { return file_; }

private:
  void skip();

  std::string file_;
  std::string_view text_;
  std::size_t place_ = 0;
  int line_, taken_line_;
  bool comments_;
};

/// The result of `make`; an Error in it gets file and line.
template <class Make> auto placed(const std::string& file, int line, const Make& make) {
  try {
    return make();
  } catch (const Error& error) {
    fail_at(file, line, error.message());
  }
}

/// Most control points in a direction: a larger number means a damaged file.
inline constexpr int most_functions = 10'000'000;

/// Reads functions + degree + 1 knots of an open knot vector.
KnotVector read_knots(TextReader& from, int degree, int functions);

Geometry read_gismo(const std::string& file, const std::string& text);
Geometry read_geopdes(const std::string& file, const std::string& text);
Geometry read_mfem(const std::string& file, const std::string& text);

/// Contents of files in each format.
std::string gismo(const Geometry& geometry);
std::string geopdes(const Geometry& geometry);
std::string mfem(const Geometry& geometry);

} // namespace signorini::exchange
