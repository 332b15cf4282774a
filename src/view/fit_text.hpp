#pragma once
// Texts in little room: on several lines, smaller, and where that is not enough cut short.

#include <string>
#include <vector>

namespace signorini::view {

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
