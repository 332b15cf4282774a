#pragma once
// The legend right of a chart.

#include "view/curves.hpp"

namespace signorini::view {

struct Legend {
  double size = 0, width = 0, row = 0; ///< pixels; no width without rows
  struct Row {
    std::string label;
    std::optional<std::size_t> series = {}; ///< whose curve stands before it
    std::optional<int> mark = {};           ///< whose marker does; a row with neither is a title, or a gap
  };
  std::vector<Row> rows;
};

/// `height`: pixels it may take. Throws Error when the rows do not fit.
Legend make_legend(const std::vector<Series>& series, const ChartOptions& options, const Style& style, double height);

/// Draws it right of the box, from its top down.
void draw_legend(Drawing& drawing, const Legend& legend, const std::vector<Series>& series, const Box& box,
                 const Style& style);

} // namespace signorini::view
