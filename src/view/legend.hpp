#pragma once
// The legend of a chart: right of it, or below it in columns where that gives its names more room.

#include "view/curves.hpp"
#include "view/fit_text.hpp"

namespace signorini::view {

struct Legend {
  struct Row {
    std::string label;
    std::optional<std::size_t> series = {}; ///< whose curve stands before it
    std::optional<int> mark = {};           ///< whose marker does; a row with neither is a title, or a gap
    FittedText text = {};                   ///< the label as it is drawn, of one line
  };
  std::vector<Row> rows;
  double row = 0;    ///< pixels from one row to the next
  double width = 0;  ///< pixels beside the chart; none without rows, or below it
  double height = 0; ///< pixels below the chart; none beside it
  int columns = 1;   ///< below the chart
};

/// `height`: pixels that it may take beside the chart. Names shrink and are cut short where they are too long. Throws
/// Error when there are too many rows.
Legend make_legend(const std::vector<Series>& series, const ChartOptions& options, const Style& style, double height);

/// Draws it right of the box, from its top down, or at the figure's bottom.
void draw_legend(Drawing& drawing, const Legend& legend, const std::vector<Series>& series, const Box& box,
                 const Style& style);

} // namespace signorini::view
