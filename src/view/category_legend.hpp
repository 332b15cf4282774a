#pragma once
// The list of categories right of a map.

#include "view/categories.hpp"
#include "view/fit_text.hpp"

namespace signorini::view {

struct CategoryLegend {
  std::vector<Category> rows;
  std::vector<FittedText> names;          ///< of the rows, as they are drawn
  double size = 0, swatch = 0, width = 0; ///< pixels; no width without rows
};

/// `width`, `height`: pixels it may take. Long names stand on several lines, are smaller than the
/// others, or cut short. Throws Error when there
/// are too many rows.
CategoryLegend make_legend(const std::vector<Category>& rows, double width, double height, const Style& style);

/// From the point to the right and downwards.
void draw_legend(Drawing& drawing, const CategoryLegend& legend, const Vec2& top_left, const Style& style);

} // namespace signorini::view
