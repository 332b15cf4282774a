#pragma once
// Line and scatter charts as PNG, SVG or PDF, drawn off-screen.

#include "view/figure.hpp"
#include "view/spot.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace signorini::view {

inline constexpr int no_marker = -1;
inline constexpr int gray = -1; ///< neutral color that no curve has by default, for comparison curves

/// Names of the markers: eight filled, then eight open.
const std::vector<std::string>& marker_names();

/// One curve. x and y have equal length; non-finite points leave a gap. A point between gaps has a marker.
struct Series {
  std::string label;
  std::vector<double> x, y;
  bool line = true; ///< draw the line
  std::optional<bool> markers =
      {}; ///< at each point (true) or none (false); default: a few per line if there are several
  bool dashed = false;
  bool arrows = false; ///< on the line, in the order of its points, e.g. to show the direction of a hysteresis
  double width = 3;    ///< of the line, in pixels of a chart of 1600 × 1000
  std::optional<int> color = {};  ///< same look as the series of this number (from 0), or gray; default: its own
  std::optional<int> marker = {}; ///< in marker_names(), or no_marker; default: that of the look
  std::vector<int> marks =
      {}; ///< one per point, index into ChartOptions::marks; their markers replace those of the curve
  std::vector<double> error =
      {}; ///< half heights of a band about the curve, empty or one ≥ 0 per point; non-finite ones leave a gap in it
};

enum class Corner { north_east, north_west, south_east, south_west };
inline constexpr Corner corners[] = {Corner::north_east, Corner::north_west, Corner::south_east, Corner::south_west};

/// A part of the chart, magnified in a box within the chart.
struct Inset {
  std::array<double, 2> xrange;
  std::optional<std::array<double, 2>> yrange = {}; ///< default: the range of the curves within xrange
  std::optional<Corner> place = {};                 ///< default: the corner with the fewest curves
};

/// Outside: right of the chart, or below it. Automatic: within the chart if a corner is free of curves, reference lines
/// and insets.
enum class LegendPlace { none, automatic, inside, outside };

struct ChartOptions {
  std::string title, xlabel, ylabel;
  bool log_x = false, log_y = false;
  LegendPlace legend = LegendPlace::automatic; ///< omitted for a single unlabeled series
  std::string legend_title;                    ///< above the names of the curves
  std::vector<std::string> marks;              ///< kinds of points, each with its own marker: second part of the legend
  std::string marks_title;                     ///< above these names
  std::optional<std::array<double, 2>> xrange, yrange;
  std::vector<Name> xticks;         ///< in ascending order; they replace the numbers
  std::vector<Name> hlines, vlines; ///< reference lines across the chart; the text may be empty
  std::optional<Inset> inset;
  std::array<int, 2> size = {1600, 1000};
};

/// Curves with equal label and look share a row of the legend. If no corner is free for an inset, the y axis is
/// extended, unless yrange is given. Requires a series, x and y of equal length, and ascending ranges. Throws Error on
/// data without finite points, values ≤ 0 on a log axis, ticks that do not ascend, more marks than markers, or an inset
/// without data.
Figure chart_figure(const std::vector<Series>& series, const ChartOptions& options);

/// The visible data points of the same figure, curve by curve, in their order. Throws like chart_figure().
std::vector<Spot> chart_spots(const std::vector<Series>& series, const ChartOptions& options);

} // namespace signorini::view
