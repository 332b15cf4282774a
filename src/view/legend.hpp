#pragma once
// Legends: of a chart within it, right of it, or below it in columns; of a map right of it.

#include "view/categories.hpp"
#include "view/curves.hpp"
#include "view/text.hpp"

namespace signorini::view {

struct Legend {
  struct Row {
    std::string label;
    std::optional<std::size_t> series = {}; ///< whose curve stands before it
    std::optional<int> mark = {};           ///< whose marker does
    std::optional<Look> look = {};          ///< whose color does; a row with none of the three is a title, or a gap
    FittedText text = {};                   ///< the label as it is drawn
  };
  std::vector<Row> rows;
  double sign = 0;                ///< pixels before the names
  double size = 0;                ///< of names that are not long
  double row = 0;                 ///< pixels from one row of one line to the next
  double width = 0;               ///< pixels beside the chart; none without rows, or elsewhere
  double height = 0;              ///< pixels below the chart; none elsewhere
  int columns = 1;                ///< below the chart
  std::optional<Box> within = {}; ///< the chart
};

/// Right of a chart or below it. `height`: pixels that it may take beside the chart. Names shrink and are cut short
/// where they are too long. Throws Error when there are too many rows.
Legend make_legend(const std::vector<Series>& series, const ChartOptions& options, const Style& style, double height);

/// In the first corner of the frame, from the north-east on, in which it hides nothing of these lines; `always`: where
/// it hides least. Nothing where it is larger than half of the frame.
std::optional<Legend> legend_within(const std::vector<Series>& series, const ChartOptions& options, const Box& frame,
                                    const Lines& lines, bool always, const Style& style);

/// Of categories; `width`, `height`: pixels it may take. Long names stand on several lines, are smaller than the
/// others, or cut short. Throws Error when there are too many rows.
Legend make_legend(const std::vector<Category>& categories, double width, double height, const Style& style);

/// Draws it within the box, right of it from its top down, or at the figure's bottom.
void draw_legend(Drawing& drawing, const Legend& legend, const std::vector<Series>& series, const Box& box,
                 const Style& style);

} // namespace signorini::view
