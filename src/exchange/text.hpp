#pragma once
// Numbers and words of text files, with the lines that messages name; and the forms of exchange files one by one.

#include "base/error.hpp"
#include "nurbs/patch.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace signorini::exchange {

using nurbs::KnotVector;
using nurbs::Patch;

/// The shortest decimal number that is read as these bits.
std::string digits(double value);
/// Numbers with blanks between them, and the end of the line.
template <class Values> std::string line_of(const Values& values) {
  std::string result;
  for (const auto& value : values) result += (result.empty() ? "" : " ") + digits(value);
  return result + "\n";
}

/// Throws Error with the place in front of what is wrong there.
[[noreturn]] void fail_at(const std::string& file, int line, const Message& problem);

/// Reads words from a text, one behind the other.
class TextReader {
public:
  /// `file` is the name in messages, `line` that of the text's first line. Where `comments` is true the rest of a line
  /// behind # is skipped.
  TextReader(std::string file, std::string_view text, int line = 1, bool comments = true);

  /// Whether there is no further word.
  bool at_end();
  /// The next word, without taking it; empty at the end.
  std::string_view peek();
  /// Takes the next word. Code and data say in messages what is expected: "exchange.expected.knot".
  std::string_view word(const char* code, std::initializer_list<Datum> data = {});
  /// Takes the next word, which must be this one.
  void keyword(std::string_view word);
  double number(const char* code);
  int integer(int low, int high, const char* code, std::initializer_list<Datum> data = {});
  /// Takes what is left of the present line.
  std::string_view rest_of_line();
  /// Throws Error at the line of the last word taken.
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

/// What `make` returns; an Error in it gets file and line in front.
template <class Make> auto placed(const std::string& file, int line, const Make& make) {
  try {
    return make();
  } catch (const Error& error) {
    fail_at(file, line, error.message());
  }
}

/// How many control points there may be in a direction: more than memory holds is a broken file.
inline constexpr int most_functions = 10'000'000;

/// degree+1 more knots than functions, as an open knot vector.
KnotVector read_knots(TextReader& from, int degree, int functions);

std::vector<Patch> read_gismo(const std::string& file, const std::string& text);
std::vector<Patch> read_geopdes(const std::string& file, const std::string& text);
std::vector<Patch> read_mfem(const std::string& file, const std::string& text);

/// The bytes of files.
std::string gismo(const std::vector<Patch>& patches);
std::string geopdes(const std::vector<Patch>& patches);
std::string mfem(const std::vector<Patch>& patches);

} // namespace signorini::exchange
