#pragma once
// A part of a chart, magnified in a box within the chart.

#include "view/curves.hpp"

namespace signorini::view {

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
