#pragma once
// Legends: of a chart within it, right of it, or below it in columns; of a map right of it.

#include "view/categories.hpp"
#include "view/curves.hpp"
#include "view/text.hpp"

namespace signorini::view {

struct Legend {
  struct Row {
    std::string label;
    std::optional<std::size_t> series = {}; ///< draws the curve of this series
    std::optional<int> mark = {};           ///< draws this marker
    std::optional<Look> look = {}; ///< draws a cell in this color; without any of the three the row is a title or a gap
    FittedText text = {};          ///< the label as drawn
  };
  std::vector<Row> rows;
  double sign = 0;                ///< width of the symbol, pixels
  double size = 0;                ///< font size of names that are not shrunk
  double row = 0;                 ///< distance of rows of one line, pixels
  double width = 0;               ///< pixels right of the chart; 0 without rows or elsewhere
  double height = 0;              ///< pixels below the chart; 0 elsewhere
  int columns = 1;                ///< if below the chart
  std::optional<Box> within = {}; ///< box in the chart
};

/// Right of a chart or below it. `height`: maximum next to the chart, pixels. Names that are too long are shrunk and
/// truncated. Throws Error when there are too many rows.
Legend make_legend(const std::vector<Series>& series, const ChartOptions& options, const Style& style, double height);

/// In the first corner of the frame, from the north-east on, in which it covers none of these lines; `always`: where it
/// covers least. Empty if it is larger than half of the frame.
std::optional<Legend> legend_within(const std::vector<Series>& series, const ChartOptions& options, const Box& frame,
                                    const Lines& lines, bool always, const Style& style);

/// Legend of categories; `width`, `height`: maximum, pixels. Names are wrapped, shrunk, or truncated. Throws Error when
/// there are too many rows.
Legend make_legend(const std::vector<Category>& categories, double width, double height, const Style& style);

/// Draws it within the box, right of it from its top down, or at the bottom of the figure.
void draw_legend(Drawing& drawing, const Legend& legend, const std::vector<Series>& series, const Box& box,
                 const Style& style);

} // namespace signorini::view
