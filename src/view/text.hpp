#pragma once
// Lines of text: superscripts and subscripts, text widths, and fitting by wrapping, shrinking and truncation.

#include <string>
#include <string_view>
#include <vector>

namespace signorini::view {

/// A part of a text on one level: 0 on the baseline, +1 superscript, −1 subscript.
struct TextRun {
  std::string string;
  int level;
};

/// Splits a text at changes of level. Superscripts and subscripts of Unicode (10⁻³, σ₁₁) become plain characters with a
/// level, because few fonts contain all of them. `_{…}` lowers and `^{…}` raises the content of the braces; `^` raises
/// the following letters and digits with their sign (mm^2, 10^-3); `_` lowers them if it follows a single letter or a
/// sign such as ∫ or ∂ (u_y, p_max, ∫_Γ), so that max_pressure and a_b_c are unchanged. A backslash before _ ^ { } or
/// \\ escapes the character.
std::vector<TextRun> text_runs(std::string_view utf8);

/// Font size of a run and height of its baseline, relative to the size of the line.
double run_size(int level);
double run_rise(int level);

/// The code points of UTF-8 text; an invalid byte becomes U+FFFD.
std::vector<char32_t> code_points(std::string_view utf8);
std::string to_utf8(char32_t point);

/// Warns of a text that is not UTF-8.
void warn_of_broken(std::string_view utf8);

/// Width in pixels of a line as drawn, proportional to its size.
double text_width(std::string_view utf8, double size);

struct FittedText {
  std::vector<std::string> lines;
  double size = 0;  ///< of all lines, pixels
  bool cut = false; ///< truncated: ends with "…"

  /// Width of the longest line, pixels.
  double width() const;
  /// From the first baseline to the last, pixels.
  double depth() const;
};

/// Distance between baselines of lines, relative to the font size.
inline constexpr double line_step = 1.2;

/// Fits a text into `space` pixels: at the wanted size, on up to `most` lines, smaller down to `least`; the rest is
/// replaced by "…".
FittedText fit_text(const std::string& text, double wanted, double least, double space, int most = 1);

} // namespace signorini::view
