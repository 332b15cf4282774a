#pragma once
// Names along axes of equal cells.

#include "view/fit_text.hpp"
#include "view/frame.hpp"

namespace signorini::view {

/// How the names of a row or column of cells are written so that none runs into the next.
struct CellNames {
  std::vector<FittedText> names; ///< long ones smaller than the others, on several lines, or cut short
  double size = 0;               ///< of those that are not long, pixels
  bool upright = false;          ///< from bottom to top
  std::size_t stride = 1;        ///< each how manieth is written, the first one always
  double room = 0;               ///< pixels from the cells to the far end of the names
};

/// Names below cells of this width. Long ones stand on several lines or upright; where even these are too dense, some
/// are left out. `most`: pixels that they may take downwards.
CellNames names_below(const std::vector<std::string>& names, double width, double most, const Style& style);
/// Names left of cells of this height; `most`: pixels that they may take to the left.
CellNames names_beside(const std::vector<std::string>& names, double height, double most, const Style& style);

/// Names, and ticks where not every cell has one, below or left of the box.
void draw_names_below(Drawing& drawing, const CellNames& names, const Box& box, const Style& style);
void draw_names_beside(Drawing& drawing, const CellNames& names, const Box& box, const Style& style);

} // namespace signorini::view
