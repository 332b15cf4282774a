#pragma once
// The curves, reference lines and inset of a chart: how each looks, its drawing in a frame, and what it covers.

#include "view/chart.hpp"

#include <limits>

namespace signorini::view {

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void take(double value);
  bool empty() const { return low > high; }
};

/// The given range, or the values' own with a little air, a part of their width; a single value, or values that only
/// rounding tells apart, get room on both sides. `axis` names it in the Error on a given range below zero on a log
/// axis.
Range axis_range(const Range& values, const std::optional<std::array<double, 2>>& given, bool log,
                 const std::string& axis, double air);

/// Whether a point of the series is drawn: both coordinates are finite.
bool drawn(const Series& s, std::size_t point);

/// The colors of curves, in their order, and the neutral one.
const std::vector<Rgb>& curve_colors();
/// How many curves are told apart by color and dashes.
int distinct_curves();
inline constexpr Rgb gray_color = {196, 196, 196};

/// How a series looks. Gray prints tell lines apart by their markers, and from the ninth on by
/// dashes and open markers.
struct CurveLook {
  Rgb color;
  int marker; ///< or no_marker, also where its points have marks of their own
  double width;
  std::vector<double> dash;

  bool operator==(const CurveLook&) const = default;
};

CurveLook look_of(const std::vector<Series>& series, std::size_t index, const Style& style);

/// Where the curves run for x within `within`, their crossings of its ends included; empty when they do not.
Range range_within(const std::vector<Series>& series, const std::array<double, 2>& within, bool log_x, bool log_y);

void draw_series(Drawing& drawing, const std::vector<Series>& series, std::size_t index, const Frame& frame,
                 const Style& style);

/// The sign of this number in marker_names(), of about the given radius, with a thin white rim; larger numbers start
/// again.
void draw_marker(Drawing& drawing, int marker, const Vec2& at, double radius, const Rgb& color);

/// A stretch of curve and the marker on it, as in a legend; points with marks have their own part of the legend.
void draw_sample(Drawing& drawing, const Series& s, const CurveLook& look, const Vec2& from, const Vec2& to,
                 const Style& style);

/// The marker of a kind of points, without the color of any curve.
void draw_mark_sample(Drawing& drawing, int mark, const Vec2& at, const Style& style);

using Lines = std::vector<std::vector<Vec2>>;

/// All that the series draw in a frame as lines in pixels.
Lines lines_of(const std::vector<Series>& series, const Frame& frame, const Style& style);

/// Length in pixels of what lies inside the box: how much a thing put there would hide.
double covered(const Lines& lines, const Box& box);

/// The reference lines of options.hlines and .vlines that cross the frame.
void draw_rules(Drawing& drawing, const ChartOptions& options, const Frame& frame, const Style& style);

/// Their texts, each beside its line where it hides least of the curves, and away from the boxes in `taken`.
void draw_rule_texts(Drawing& drawing, const ChartOptions& options, const Frame& frame, const Lines& curves,
                     std::vector<Box> taken, const Style& style);

/// A box of this width and height in a corner of another one, `gap` pixels away from its sides.
Box corner_box(Corner corner, const Vec2& size, const Box& box, double gap);

struct PlacedInset {
  Frame frame;
  Style style;   ///< smaller than the chart's
  Box outer;     ///< all that the inset covers, in pixels
  Box marked;    ///< the magnified region in the chart
  double hidden; ///< pixels of curve beneath it
};

/// The largest box in a corner of the chart that hides neither curves nor the magnified region, or the small one that
/// hides least; nor the chart's legend. Throws Error when the region has no data or lies outside the chart.
PlacedInset place_inset(const std::vector<Series>& series, const ChartOptions& options, const Frame& chart,
                        const Style& style, const std::optional<Box>& legend = {});

void draw_inset(Drawing& drawing, const std::vector<Series>& series, const ChartOptions& options,
                const PlacedInset& inset);

} // namespace signorini::view
