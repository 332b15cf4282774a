#include "view/category_legend.hpp"

#include "base/error.hpp"
#include "view/text.hpp"

#include <algorithm>

namespace signorini::view {

constexpr Rgb rim = {70, 70, 70};

CategoryLegend make_legend(const std::vector<Category>& rows, double width, double height, const Style& style) {
  CategoryLegend legend{rows};
  if (rows.empty()) return legend;
  double widest = 0;
  for (const Category& row : rows) widest = std::max(widest, text_width(row.name, 1.0));
  // A row: swatch of 1.5 sizes, gap of 0.5, name.
  legend.size =
      std::min({0.9 * style.label_size, height / (1.6 * static_cast<double>(rows.size())), width / (widest + 2.0)});
  require(legend.size >= 5, "the legend of ", rows.size(),
          " categories does not fit beside the map; choose shorter names or a larger size");
  legend.row = 1.6 * legend.size;
  legend.swatch = 1.5 * legend.size;
  legend.width = legend.swatch + (0.5 + widest) * legend.size;
  return legend;
}

void draw_legend(Drawing& drawing, const CategoryLegend& legend, const Vec2& top_left, const Style& style) {
  const auto [left, top] = top_left;
  for (std::size_t n = 0; n < legend.rows.size(); ++n) {
    const double high = top - n * legend.row, low = high - 1.15 * legend.size, right = left + legend.swatch;
    fill_cell(drawing, {left, right, low, high}, legend.rows[n].look, style);
    drawing.marks.push_back(Stroke{
        {{left, low}, {right, low}, {right, high}, {left, high}, {left, low}, {right, low}}, rim, 1.2 * style.unit});
    drawing.marks.push_back(Text{{right + 0.5 * legend.size, 0.5 * (low + high) - 0.35 * legend.size},
                                 legend.rows[n].name,
                                 legend.size,
                                 Align::left,
                                 ink});
  }
}

} // namespace signorini::view
