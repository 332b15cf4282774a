#pragma once
// Line and scatter charts to PNG, SVG or PDF, drawn off-screen.

#include "view/figure.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace signorini::view {

inline constexpr int no_marker = -1;
inline constexpr int gray = -1; ///< a color of no curve, for what others are compared with

/// Names of the markers: eight filled ones, then eight open ones.
const std::vector<std::string>& marker_names();

/// One curve. x and y have equal length; points that are not finite leave a gap. A point between gaps has a marker.
struct Series {
  std::string label;
  std::vector<double> x, y;
  bool line = true;                 ///< draw the line
  std::optional<bool> markers = {}; ///< at each point, or none; when absent a few on each line of several
  bool dashed = false;
  bool arrows = false;            ///< on the line, in the order of its points: which way a hysteresis runs
  double width = 3;               ///< of the line, in pixels of a chart of 1600 × 1000
  std::optional<int> color = {};  ///< looks like the series of this number (from 0), or gray; its own when absent
  std::optional<int> marker = {}; ///< in marker_names(), or no_marker; the look's own when absent
  std::vector<int> marks = {};    ///< one per point, in ChartOptions::marks: their markers take the place of its own
};

enum class Corner { north_east, north_west, south_east, south_west };
inline constexpr Corner corners[] = {Corner::north_east, Corner::north_west, Corner::south_east, Corner::south_west};

/// A part of the chart, drawn once more and larger in a box within the chart.
struct Inset {
  std::array<double, 2> xrange;
  std::optional<std::array<double, 2>> yrange = {}; ///< the curves' own within xrange when absent
  std::optional<Corner> place = {};                 ///< the emptiest corner when absent
};

/// Outside is right of the chart, or below it. Automatic: within the chart where a corner is free of curves and
/// reference lines, and no inset wants it.
enum class LegendPlace { none, automatic, inside, outside };

struct ChartOptions {
  std::string title, xlabel, ylabel;
  bool log_x = false, log_y = false;
  LegendPlace legend = LegendPlace::automatic; ///< left out for a single unlabeled series
  std::string legend_title;                    ///< above the curves' names
  std::vector<std::string> marks; ///< what points are, each with a marker of its own: the legend's second part
  std::string marks_title;        ///< above these names
  std::optional<std::array<double, 2>> xrange, yrange;
  std::vector<Name> xticks;         ///< in rising order; they take the place of numbers
  std::vector<Name> hlines, vlines; ///< reference lines across the chart; the text may be empty
  std::optional<Inset> inset;
  std::array<int, 2> size = {1600, 1000};
};

/// Curves of one label and look share a row of the legend. Where an inset finds no free corner, the y axis goes on
/// until there is one, unless yrange is given. Needs a series, as many y as x, and ranges that rise. Throws Error on
/// nothing finite to draw, values ≤ 0 on a log axis, ticks that do not rise, more marks than markers, or an inset
/// without data.
Figure chart_figure(const std::vector<Series>& series, const ChartOptions& options);

} // namespace signorini::view
