#pragma once
// Lines of text: raised and lowered digits, how wide a line will be, and how it is fitted into little room: on several
// lines, smaller, and where that is not enough cut short.

#include <string>
#include <string_view>
#include <vector>

namespace signorini::view {

/// A stretch of text on one level: 0 on the baseline, +1 raised, −1 lowered.
struct TextRun {
  std::string string;
  int level;
};

/// Splits a text where its level changes. Unicode's superscripts and subscripts (10⁻³, σ₁₁) come back as plain
/// characters on their level: few fonts hold all of them. `_{…}` lowers and `^{…}` raises what the braces hold; `^`
/// raises the letters and digits behind it, with their sign (mm^2, 10^-3), and `_` behind a single letter, or a sign
/// such as ∫ or ∂, lowers them (u_y, p_max, ∫_Γ). So max_pressure and a_b_c are plain. A backslash before _ ^ { } or
/// \\ stands for the sign itself.
std::vector<TextRun> text_runs(std::string_view utf8);

/// Size of a run's characters and height of its baseline, relative to the line's size.
double run_size(int level);
double run_rise(int level);

/// The code points of UTF-8 text; a byte that is no UTF-8 comes back as U+FFFD.
std::vector<char32_t> code_points(std::string_view utf8);
std::string to_utf8(char32_t point);

/// Warns of a text that is not UTF-8.
void warn_of_broken(std::string_view utf8);

/// Width in pixels of a line as it will be drawn, proportional to its size (renderer.hpp).
double text_width(std::string_view utf8, double size);

struct FittedText {
  std::vector<std::string> lines;
  double size = 0;  ///< of all lines, pixels
  bool cut = false; ///< ends with "…" in the place of the rest

  /// Of the longest line, pixels.
  double width() const;
  /// From the first baseline to the last, pixels.
  double depth() const;
};

/// The baselines of lines stand this far apart, in their size.
inline constexpr double line_step = 1.2;

/// Fits a text into `room` pixels: at the wanted size, on up to `most` lines, smaller down to `least`; what is left
/// then gives way to "…".
FittedText fit_text(const std::string& text, double wanted, double least, double room, int most = 1);

} // namespace signorini::view
