#include "view/text.hpp"

#include <algorithm>
#include <sstream>

namespace signorini::view {
namespace {

/// Lines of whole words; a word that is too long has its own line.
std::vector<std::string> wrapped(const std::string& text, double size, double space) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.empty() ? word : lines.back() + " " + word;
    if (!lines.empty() && text_width(longer, size) <= space)
      lines.back() = longer;
    else
      lines.push_back(word);
  }
  return lines;
}

double widest(const std::vector<std::string>& lines, double size) {
  double width = 0;
  for (const std::string& line : lines) width = std::max(width, text_width(line, size));
  return width;
}

/// Wraps a text into at most `most` lines of similar length; empty if it does not fit.
std::vector<std::string> lines_within(const std::string& text, double size, double space, int most) {
  if (most == 1) return text_width(text, size) <= space ? std::vector{text} : std::vector<std::string>{};
  const auto fits = [&](const std::vector<std::string>& lines) {
    return !lines.empty() && static_cast<int>(lines.size()) <= most && widest(lines, size) <= space;
  };
  std::vector<std::string> lines = wrapped(text, size, space);
  if (!fits(lines)) return {};
  for (double narrower = 0.97 * space; narrower > 0.4 * space; narrower -= 0.03 * space) {
    std::vector<std::string> next = wrapped(text, size, narrower);
    if (!fits(next) || next.size() > lines.size()) break;
    lines = std::move(next);
  }
  return lines;
}

/// Closes braces that truncation has left open.
std::string closed(const std::string& text) {
  const std::size_t open = std::max(text.rfind("_{") + 1, text.rfind("^{") + 1); // 0 if there is none
  return open > 0 && text.find('}', open) == std::string::npos ? text + "}" : text;
}

/// Truncates to as many characters as fit before "…".
std::string cut_short(const std::string& text, double size, double space) {
  if (text_width(text, size) <= space) return text;
  std::vector<char32_t> points = code_points(text);
  for (; !points.empty(); points.pop_back()) {
    if (points.back() == U' ') continue;
    std::string kept;
    for (char32_t point : points) kept += to_utf8(point);
    kept = closed(kept) + "…";
    if (text_width(kept, size) <= space) return kept;
  }
  return "…";
}

/// Full lines at the minimum size, the last one truncated.
FittedText shortened(const std::string& text, double size, double space, int most) {
  std::vector<std::string> lines = wrapped(text, size, space);
  for (auto at = static_cast<std::size_t>(most); at < lines.size(); ++at) lines[most - 1] += " " + lines[at];
  lines.resize(std::min(lines.size(), static_cast<std::size_t>(most)));
  for (std::string& line : lines) line = cut_short(line, size, space);
  return {lines, size, true};
}

} // namespace

double FittedText::width() const {
  return widest(lines, size);
}

double FittedText::depth() const {
  return lines.empty() ? 0 : line_step * size * static_cast<double>(lines.size() - 1);
}

FittedText fit_text(const std::string& text, double wanted, double least, double space, int most) {
  constexpr double near = 0.85; // of the wanted size: shrink slightly before adding a line
  FittedText best;
  for (int count = 1; count <= most && best.size < near * wanted; ++count)
    for (double size = wanted; size >= least && size > best.size * (1 + 1e-9); size *= 0.97) {
      std::vector<std::string> lines = lines_within(text, size, space, count);
      if (!lines.empty()) best = {std::move(lines), size};
    }
  return best.lines.empty() ? shortened(text, std::min(least, wanted), space, most) : best;
}

} // namespace signorini::view
