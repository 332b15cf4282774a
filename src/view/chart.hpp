#pragma once
// Line and scatter charts to PNG, SVG or PDF, drawn off-screen.

#include "base/eigen.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace signorini::view {

/// One curve. x and y have equal length; points with NaN leave a gap.
struct Series {
  std::string label;
  std::vector<double> x, y;
  bool line = true;     ///< draw the line
  bool markers = false; ///< draw markers
  bool dashed = false;
};

struct ChartOptions {
  std::string title, xlabel, ylabel;
  bool log_x = false, log_y = false;
  bool legend = true; ///< right of the data, never over it; left out for a single unlabelled series
  std::optional<std::array<double, 2>> xrange, yrange;
  std::array<int, 2> size = {1600, 1000};
};

/// Draws to .png, .svg or .pdf (by the ending), whole or not at all. The same call gives the same bytes.
/// Throws Error on no series, unequal lengths, nothing finite to draw, values ≤ 0 on a log axis, unknown ending, or a
/// file that cannot be written.
void draw_chart(const std::vector<Series>& series, const ChartOptions& options, const std::string& file);

} // namespace signorini::view
