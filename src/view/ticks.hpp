#pragma once
// Where an axis is marked, and with which numbers.

#include "view/fit_text.hpp"

#include <string>
#include <vector>

namespace signorini::view {

struct Ticks {
  std::vector<double> at;
  std::vector<std::string> labels; ///< one per tick
  std::vector<double> minor;       ///< unlabelled marks between them
  std::string factor;              ///< common power of ten of all labels, "×10⁻³", or empty
  std::vector<FittedText> names;   ///< empty, or one per tick, as its label is drawn
  bool upright = false;            ///< names read from bottom to top
  double depth = 0;                ///< pixels that names take below the row that numbers would stand in
};

/// A value with three digits at most, as in −1.32×10^{-4}.
std::string in_digits(double value);

/// Fails where a range [low, high] is too wide or too narrow to be divided in double precision.
void require_drawable(double low, double high, bool log);

/// At most `count` (≥ 2) round numbers 1, 2, 5 × 10ᵏ apart within [low, high]. Needs low < high.
Ticks linear_ticks(double low, double high, int count);

/// Powers of ten within [low, high]; below a decade and a half 2 and 5 times them, too; below a factor of 5, where
/// these are few, round numbers as on a linear axis. With minor ticks between. Needs 0 < low < high.
Ticks log_ticks(double low, double high, int count);

} // namespace signorini::view
