#pragma once
// Curves, reference lines and insets of charts: looks, drawing, and the area that they cover.

#include "view/chart.hpp"

#include <limits>

namespace signorini::view {

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void take(double value);
  bool empty() const { return low > high; }
};

/// The given range, or that of the values with a margin proportional to its width; a single value, or values that
/// differ by rounding error only, are widened on both sides. `axis`: name of the axis in the Error on a given range ≤ 0
/// on a log axis.
Range axis_range(const Range& values, const std::optional<std::array<double, 2>>& given, bool log,
                 const std::string& axis, double margin);

/// True if both coordinates of the point are finite.
bool drawn(const Series& s, std::size_t point);

/// The colors of curves, in order, and the neutral one.
const std::vector<Rgb>& curve_colors();
/// Number of curves that colors and dashes distinguish.
int distinct_curves();
inline constexpr Rgb gray_color = {196, 196, 196};

/// The look of a series. In gray prints, markers distinguish the lines; from the ninth on, also dashes and open
/// markers.
struct CurveLook {
  Rgb color;
  int marker; ///< or no_marker, also where points have marks
  double width;
  std::vector<double> dash;

  bool operator==(const CurveLook&) const = default;
};

CurveLook look_of(const std::vector<Series>& series, std::size_t index, const Style& style);

/// y range of the curves for x within `within`, including where they cross its ends; empty if they lie outside. Errors
/// extend it by at most the span of the curves, or the size of constant ones; on a log axis downwards by at most a
/// decade.
Range range_within(const std::vector<Series>& series, const std::array<double, 2>& within, bool log_x, bool log_y);

/// The bands, then the curves, the first one on top.
void draw_series(Drawing& drawing, const std::vector<Series>& series, const Frame& frame, const Style& style);

/// The marker of this number in marker_names(), of about the given radius, with a thin white rim; numbers are taken
/// modulo their count.
void draw_marker(Drawing& drawing, int marker, const Vec2& at, double radius, const Rgb& color);

/// Line and marker of a curve, as in a legend; points with marks are listed separately.
void draw_sample(Drawing& drawing, const Series& s, const CurveLook& look, const Vec2& from, const Vec2& to,
                 const Style& style);

/// The marker of a kind of points, in no curve's color.
void draw_mark_sample(Drawing& drawing, int mark, const Vec2& at, const Style& style);

using Lines = std::vector<std::vector<Vec2>>;

/// Everything that the series draw in a frame, as lines in pixels; bands by their edges.
Lines lines_of(const std::vector<Series>& series, const Frame& frame, const Style& style);

/// Length in pixels of the lines inside the box: measures how much an object there would cover.
double covered(const Lines& lines, const Box& box);

/// The reference lines of options.hlines and .vlines that lie within the frame.
void draw_rules(Drawing& drawing, const ChartOptions& options, const Frame& frame, const Style& style);

/// Their texts, each next to its line where it covers the fewest curves, outside the boxes in `taken`.
void draw_rule_texts(Drawing& drawing, const ChartOptions& options, const Frame& frame, const Lines& curves,
                     std::vector<Box> taken, const Style& style);

/// A box of this width and height in a corner of `box`, `gap` pixels away from its sides.
Box corner_box(Corner corner, const Vec2& size, const Box& box, double gap);

struct PlacedInset {
  Frame frame;
  Style style;   ///< smaller than the chart's
  Box outer;     ///< everything that the inset covers, in pixels
  Box marked;    ///< the magnified region in the chart
  double hidden; ///< pixels of curve that the inset covers
};

/// The largest box in a corner of the chart that covers no curves, legend or magnified region, or the small one that
/// covers least. Throws Error when the region has no data or lies outside the chart.
PlacedInset place_inset(const std::vector<Series>& series, const ChartOptions& options, const Frame& chart,
                        const Style& style, const std::optional<Box>& legend = {});

void draw_inset(Drawing& drawing, const std::vector<Series>& series, const ChartOptions& options,
                const PlacedInset& inset);

} // namespace signorini::view
