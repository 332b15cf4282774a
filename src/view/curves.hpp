#pragma once
// The curves of a chart: how each looks, its drawing in a frame, and what it covers.

#include "view/chart.hpp"

#include <limits>

namespace signorini::view {

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void take(double value);
  bool empty() const { return low > high; }
};

/// The given range, or the values' own with a little air, a part of their width; a single value, or values that only
/// rounding tells apart, get room on both sides. `axis` names it in the Error on a given range that does not rise.
Range axis_range(const Range& values, const std::optional<std::array<double, 2>>& given, bool log,
                 const std::string& axis, double air);

/// Whether a point of the series is drawn: both coordinates are finite.
bool drawn(const Series& s, std::size_t point);

/// How a series looks. Grey prints tell lines apart by their markers, and from the ninth on by dashes and open markers.
struct Look {
  Rgb colour;
  int marker; ///< or no_marker
  double width;
  std::vector<double> dash;

  bool operator==(const Look&) const = default;
};

Look look_of(const std::vector<Series>& series, std::size_t index, const Style& style);

/// Where the curves run for x within `within`, their crossings of its ends included; empty when they do not.
Range range_within(const std::vector<Series>& series, const std::array<double, 2>& within, bool log_x, bool log_y);

void draw_series(Drawing& drawing, const std::vector<Series>& series, std::size_t index, const Frame& frame,
                 const Style& style);

/// A stretch of curve and the marker on it, as in a legend.
void draw_sample(Drawing& drawing, const Series& s, const Look& look, const Vec2& from, const Vec2& to,
                 const Style& style);

using Lines = std::vector<std::vector<Vec2>>;

/// All that the series draw in a frame as lines in pixels.
Lines lines_of(const std::vector<Series>& series, const Frame& frame, const Style& style);

/// Length in pixels of what lies inside the box: how much a thing put there would hide.
double covered(const Lines& lines, const Box& box);

} // namespace signorini::view
