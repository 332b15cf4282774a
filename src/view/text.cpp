#include "view/text.hpp"

#include "base/warning.hpp"

#include <optional>
#include <utility>

namespace signorini::view {
namespace {

struct Shifted {
  char32_t point, plain;
  int level;
};

constexpr Shifted shifted_signs[] = {
    {U'¹', U'1', 1},  {U'²', U'2', 1},  {U'³', U'3', 1},  {U'⁰', U'0', 1},  {U'⁺', U'+', 1},
    {U'⁻', U'−', 1},  {U'ⁿ', U'n', 1},  {U'₊', U'+', -1}, {U'₋', U'−', -1}, {U'ₐ', U'a', -1},
    {U'ₑ', U'e', -1}, {U'ₙ', U'n', -1}, {U'ₓ', U'x', -1},
};

TextRun shift(char32_t point) {
  if (point >= U'⁴' && point <= U'⁹') return {to_utf8(U'4' + (point - U'⁴')), 1};
  if (point >= U'₀' && point <= U'₉') return {to_utf8(U'0' + (point - U'₀')), -1};
  for (const Shifted& sign : shifted_signs)
    if (sign.point == point) return {to_utf8(sign.plain), sign.level};
  return {to_utf8(point), 0};
}

bool is_digit(char32_t p) {
  return p >= U'0' && p <= U'9';
}

/// Letters of any script.
bool is_letter(char32_t p) {
  return (p >= U'A' && p <= U'Z') || (p >= U'a' && p <= U'z') || (p >= 0xC0 && p < 0x2000 && p != U'×' && p != U'÷') ||
         p >= 0x2E80;
}

bool is_word(char32_t p) {
  return is_letter(p) || is_digit(p);
}

/// Signs that can have an index like letters: integrals, sums, derivatives.
bool is_operator(char32_t p) {
  constexpr std::u32string_view signs = U"∫∬∭∮∯∂∇∑∏⋃⋂";
  return signs.find(p) != signs.npos;
}

using CodePoints = std::vector<char32_t>;

/// CodePoints [from, to) are on another level; the text continues at `next`.
struct Group {
  std::size_t from, to, next;
};

/// The argument of the sign at i: the content of braces, otherwise the word that follows directly.
std::optional<Group> group_at(const CodePoints& points, std::size_t i) {
  const std::size_t count = points.size();
  const auto at = [&](std::size_t k) { return k < count ? points[k] : U' '; };
  if (at(i) != U'_' && at(i) != U'^') return std::nullopt;
  if (at(i + 1) == U'{') {
    for (std::size_t end = i + 2; end < count; ++end)
      if (points[end] == U'}' && points[end - 1] != U'\\') return Group{i + 2, end, end + 1};
    return std::nullopt;
  }
  if (i == 0 || at(i - 1) == U' ') return std::nullopt;
  std::size_t end = i + 1;
  if (at(i) == U'^' && (at(end) == U'-' || at(end) == U'−' || at(end) == U'+')) ++end;
  if (!is_word(at(end))) return std::nullopt;
  while (is_word(at(end))) ++end;
  if (at(i) == U'^') return Group{i + 1, end, end};
  // Words of several letters or parts before it are names of files and columns.
  const bool lone = is_operator(points[i - 1]) ||
                    (is_letter(points[i - 1]) && (i == 1 || (!is_word(points[i - 2]) && points[i - 2] != U'_')));
  if (!lone || at(end) == U'_') return std::nullopt;
  return Group{i + 1, end, end};
}

bool is_escaped(const CodePoints& points, std::size_t i) {
  constexpr std::u32string_view signs = U"_^{}\\";
  return points[i] == U'\\' && i + 1 < points.size() && signs.find(points[i + 1]) != signs.npos;
}

struct Runs {
  std::vector<TextRun> list;

  void add(char32_t point, int level) {
    TextRun next = shift(point < 0x20 ? U' ' : point);
    if (level != 0) next.level = level;
    if (!list.empty() && list.back().level == next.level)
      list.back().string += next.string;
    else
      list.push_back(std::move(next));
  }
};

} // namespace

std::string to_utf8(char32_t p) {
  const auto tail = [&](int shift) { return static_cast<char>(0x80 | ((p >> shift) & 0x3F)); };
  if (p < 0x80) return {static_cast<char>(p)};
  if (p < 0x800) return {static_cast<char>(0xC0 | (p >> 6)), tail(0)};
  if (p < 0x10000) return {static_cast<char>(0xE0 | (p >> 12)), tail(6), tail(0)};
  return {static_cast<char>(0xF0 | (p >> 18)), tail(12), tail(6), tail(0)};
}

std::vector<char32_t> code_points(std::string_view utf8) {
  std::vector<char32_t> points;
  for (std::size_t i = 0; i < utf8.size();) {
    const auto lead = static_cast<unsigned char>(utf8[i++]);
    const int tails = lead < 0x80 ? 0 : (lead >> 5) == 6 ? 1 : (lead >> 4) == 14 ? 2 : (lead >> 3) == 30 ? 3 : -1;
    char32_t point = tails < 0 ? 0xFFFD : tails == 0 ? lead : lead & (0x3F >> tails);
    for (int t = 0; t < tails; ++t) {
      if (i == utf8.size() || (static_cast<unsigned char>(utf8[i]) >> 6) != 2) {
        point = 0xFFFD;
        break;
      }
      point = (point << 6) | (static_cast<unsigned char>(utf8[i++]) & 0x3F);
    }
    points.push_back(point);
  }
  return points;
}

void warn_of_broken(std::string_view utf8) {
  std::string shown;
  for (char32_t point : code_points(utf8)) shown += to_utf8(point);
  if (shown != utf8) warn("view.text.encoding", {{"text", shown}});
}

std::vector<TextRun> text_runs(std::string_view utf8) {
  Runs runs;
  const CodePoints points = code_points(utf8);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_escaped(points, i)) {
      runs.add(points[++i], 0);
      continue;
    }
    const std::optional<Group> group = group_at(points, i);
    if (!group) {
      runs.add(points[i], 0);
      continue;
    }
    const int level = points[i] == U'^' ? 1 : -1;
    for (std::size_t k = group->from; k < group->to; ++k) {
      if (is_escaped(points, k)) ++k;
      runs.add(points[k] == U'-' && level > 0 ? U'−' : points[k], level);
    }
    i = group->next - 1;
  }
  return std::move(runs.list);
}

double run_size(int level) {
  return level == 0 ? 1.0 : 0.7;
}
double run_rise(int level) {
  return level > 0 ? 0.36 : level < 0 ? -0.17 : 0.0;
}

} // namespace signorini::view
