#include "view/legend.hpp"

#include "base/error.hpp"
#include "view/text.hpp"

#include <algorithm>

namespace signorini::view {
namespace {

double swatch(const Style& style) {
  return 70 * style.unit;
}

/// One row per label and look: curves that share both are one thing to the reader. Where some curves have labels, one
/// without is meant to have no row.
std::vector<Legend::Row> rows_of(const std::vector<Series>& series, const Style& style) {
  std::vector<Legend::Row> rows;
  const bool labelled = std::any_of(series.begin(), series.end(), [](const Series& one) { return !one.label.empty(); });
  for (std::size_t n = 0; n < series.size(); ++n) {
    const auto known = [&](const Legend::Row& row) {
      return row.label == series[n].label && series[*row.series].line == series[n].line &&
             look_of(series, *row.series, style) == look_of(series, n, style);
    };
    if (!labelled)
      rows.push_back({text("series ", n + 1), n});
    else if (!series[n].label.empty() && std::none_of(rows.begin(), rows.end(), known))
      rows.push_back({series[n].label, n});
  }
  return rows;
}

/// The curves with their title, then the kinds of points with theirs.
std::vector<Legend::Row> all_rows(const std::vector<Series>& series, const ChartOptions& options, const Style& style) {
  std::vector<Legend::Row> rows;
  const bool single = series.size() == 1 && series[0].label.empty();
  if (!single) rows = rows_of(series, style);
  if (!rows.empty() && !options.legend_title.empty()) rows.insert(rows.begin(), {options.legend_title});
  if (options.marks.empty()) return rows;
  if (!rows.empty()) rows.push_back({""});
  if (!options.marks_title.empty()) rows.push_back({options.marks_title});
  for (std::size_t k = 0; k < options.marks.size(); ++k) rows.push_back({options.marks[k], {}, static_cast<int>(k)});
  return rows;
}

} // namespace

Legend make_legend(const std::vector<Series>& series, const ChartOptions& options, const Style& style, double height) {
  Legend legend;
  if (options.legend) legend.rows = all_rows(series, options, style);
  if (legend.rows.empty()) return legend;
  double widest = 0;
  for (const Legend::Row& row : legend.rows) widest = std::max(widest, text_width(row.label, 1.0));
  const double room = 0.42 * options.size[0] - swatch(style);
  legend.size = std::min({style.label_size, height / (1.5 * legend.rows.size()), room / widest});
  require(legend.size >= 5, "the legend of ", legend.rows.size(), " rows does not fit a chart of ", options.size[0],
          " × ", options.size[1], " pixels; choose shorter labels, a larger size, or legend = false");
  legend.row = 1.5 * legend.size;
  legend.width = swatch(style) + 0.5 * legend.size + widest * legend.size + style.margin;
  return legend;
}

void draw_legend(Drawing& drawing, const Legend& legend, const std::vector<Series>& series, const Box& box,
                 const Style& style) {
  const double x = box[1] + style.margin;
  for (std::size_t n = 0; n < legend.rows.size(); ++n) {
    const auto& [label, index, mark] = legend.rows[n];
    const double y = box[3] - (n + 0.5) * legend.row, indent = index || mark ? swatch(style) + 0.5 * legend.size : 0;
    if (index)
      draw_sample(drawing, series[*index], look_of(series, *index, style), {x, y}, {x + swatch(style), y}, style);
    if (mark) draw_mark_sample(drawing, *mark, {x + 0.5 * swatch(style), y}, style);
    if (!label.empty())
      drawing.marks.push_back(Text{{x + indent, y - 0.35 * legend.size}, label, legend.size, Align::left, ink});
  }
}

} // namespace signorini::view
