#include "view/category_legend.hpp"

#include "base/error.hpp"

#include <algorithm>

namespace signorini::view {

constexpr Rgb rim = {70, 70, 70};

namespace {

/// Pixels from the top of a row to that of the next.
double row_height(const CategoryLegend& legend, std::size_t n) {
  return 1.6 * legend.size + legend.names[n].depth();
}

/// Fits the names into `room` pixels beside the swatches; whether they are whole and fit the height.
bool fit_names(CategoryLegend& legend, double room, double height, int lines, const Style& style) {
  legend.names.clear();
  bool whole = true;
  double needed = 0;
  for (std::size_t n = 0; n < legend.rows.size(); ++n) {
    legend.names.push_back(
        fit_text(legend.rows[n].name, legend.size, std::min(legend.size, least_size(style)), room, lines));
    whole = whole && !legend.names.back().cut;
    needed += row_height(legend, n);
  }
  return whole && needed <= height + 1e-6;
}

} // namespace

CategoryLegend make_legend(const std::vector<Category>& rows, double width, double height, const Style& style) {
  CategoryLegend legend;
  legend.rows = rows;
  if (rows.empty()) return legend;
  // A row: swatch of 1.5 sizes, gap of 0.5, name.
  legend.size = std::min(0.9 * style.label_size, height / (1.6 * static_cast<double>(rows.size())));
  require(legend.size >= std::min(least_size(style), 5.0), "the legend of ", rows.size(),
          " categories does not fit beside the map; choose a larger size");
  legend.swatch = 1.5 * legend.size;
  const double room = width - 2 * legend.size;
  // Rather on several lines than half as wide as the figure.
  if (!fit_names(legend, 0.6 * room, height, 3, style) && !fit_names(legend, room, height, 3, style))
    fit_names(legend, room, height, 1, style);
  double widest = 0;
  for (const FittedText& name : legend.names) widest = std::max(widest, name.width());
  legend.width = legend.swatch + 0.5 * legend.size + widest;
  return legend;
}

void draw_legend(Drawing& drawing, const CategoryLegend& legend, const Vec2& top_left, const Style& style) {
  const double left = top_left[0], right = left + legend.swatch;
  double high = top_left[1];
  for (std::size_t n = 0; n < legend.rows.size(); ++n) {
    const double low = high - 1.15 * legend.size;
    fill_cell(drawing, {left, right, low, high}, legend.rows[n].look, style);
    drawing.marks.push_back(Stroke{
        {{left, low}, {right, low}, {right, high}, {left, high}, {left, low}, {right, low}}, rim, 1.2 * style.unit});
    const FittedText& name = legend.names[n];
    double base = 0.5 * (low + high) - 0.35 * name.size;
    for (const std::string& line : name.lines) {
      drawing.marks.push_back(Text{{right + 0.5 * legend.size, base}, line, name.size, Align::left, ink});
      base -= line_step * name.size;
    }
    high -= row_height(legend, n);
  }
}

} // namespace signorini::view
