#pragma once
// Reference lines across a chart.

#include "view/curves.hpp"

namespace signorini::view {

/// The lines of options.hlines and .vlines that cross the frame.
void draw_rules(Drawing& drawing, const ChartOptions& options, const Frame& frame, const Style& style);

/// Their texts, each beside its line where it hides least of the curves, and away from the boxes in `taken`.
void draw_rule_texts(Drawing& drawing, const ChartOptions& options, const Frame& frame, const Lines& curves,
                     std::vector<Box> taken, const Style& style);

} // namespace signorini::view
