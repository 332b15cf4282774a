#include "view/legend.hpp"

#include "base/error.hpp"

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

/// Pixels before a row's name.
double indent(const Legend::Row& row, const Style& style) {
  return row.series || row.mark ? swatch(style) + 0.45 * style.label_size : 0;
}

/// Fits all names at a size into `room` pixels; whether they are whole.
bool fit_names(Legend& legend, double size, double room, const Style& style) {
  bool whole = true;
  for (Legend::Row& row : legend.rows) {
    row.text = fit_text(row.label, size, std::min(size, least_size(style)), room - indent(row, style));
    whole = whole && !row.text.cut;
  }
  legend.row = 1.5 * size;
  return whole;
}

double widest(const Legend& legend, const Style& style) {
  double width = 0;
  for (const Legend::Row& row : legend.rows) width = std::max(width, indent(row, style) + row.text.width());
  return width;
}

int rows_in(const Legend& legend, int columns) {
  return (static_cast<int>(legend.rows.size()) + columns - 1) / columns;
}

/// Right of the chart; whether all names are whole there.
bool put_beside(Legend& legend, double room, double height, const Style& style) {
  const double size = std::min(style.label_size, height / (1.5 * legend.rows.size()));
  if (size < least_size(style) || !fit_names(legend, size, room, style)) return false;
  legend.width = widest(legend, style) + style.margin;
  return true;
}

double column_room(const ChartOptions& options, int columns, const Style& style) {
  return (options.size[0] - 2 * style.margin) / columns - style.margin;
}

/// Below the chart, in the columns that leave the names largest; whether there is room for the rows.
bool put_below(Legend& legend, const ChartOptions& options, const Style& style) {
  const double most = 0.4 * options.size[1], least = least_size(style);
  const int count = static_cast<int>(legend.rows.size());
  legend.columns = 0;
  double best = 0;
  for (int columns = 1; columns <= count; ++columns) {
    const double size = std::min(0.9 * style.label_size, most / (1.5 * rows_in(legend, columns)));
    const double room = column_room(options, columns, style);
    if (size < least || room < swatch(style) + 5 * least) continue;
    // A name that is cut counts as one too small; fewer rows are better where names are as large.
    const bool whole = fit_names(legend, size, room, style);
    double score = whole ? size : 0.5 * least * room / options.size[0];
    for (const Legend::Row& row : legend.rows) score = whole && row.text.size < score ? row.text.size : score;
    if (score < 0.999 * best) continue;
    best = score;
    legend.columns = columns;
  }
  if (legend.columns == 0) return false;
  fit_names(legend, std::min(0.9 * style.label_size, most / (1.5 * rows_in(legend, legend.columns))),
            column_room(options, legend.columns, style), style);
  legend.height = rows_in(legend, legend.columns) * legend.row + 0.5 * style.margin;
  return true;
}

void draw_row(Drawing& drawing, const Legend::Row& row, const Vec2& at, const std::vector<Series>& series,
              const Style& style) {
  const auto [x, y] = at;
  if (row.series)
    draw_sample(drawing, series[*row.series], look_of(series, *row.series, style), at, {x + swatch(style), y}, style);
  if (row.mark) draw_mark_sample(drawing, *row.mark, {x + 0.5 * swatch(style), y}, style);
  if (!row.label.empty())
    drawing.marks.push_back(Text{
        {x + indent(row, style), y - 0.35 * row.text.size}, row.text.lines.front(), row.text.size, Align::left, ink});
}

} // namespace

Legend make_legend(const std::vector<Series>& series, const ChartOptions& options, const Style& style, double height) {
  Legend legend;
  if (options.legend) legend.rows = all_rows(series, options, style);
  if (legend.rows.empty() || put_beside(legend, 0.42 * options.size[0], height, style)) return legend;
  require(put_below(legend, options, style), "the legend of ", legend.rows.size(), " rows does not fit a chart of ",
          options.size[0], " × ", options.size[1], " pixels; choose a larger size, fewer labels, or legend = false");
  return legend;
}

void draw_legend(Drawing& drawing, const Legend& legend, const std::vector<Series>& series, const Box& box,
                 const Style& style) {
  if (legend.height == 0) {
    for (std::size_t n = 0; n < legend.rows.size(); ++n)
      draw_row(drawing, legend.rows[n], {box[1] + style.margin, box[3] - (n + 0.5) * legend.row}, series, style);
    return;
  }
  // Columns as narrow as their names, in the figure's middle.
  const auto rows = static_cast<std::size_t>(rows_in(legend, legend.columns));
  const double column = widest(legend, style) + style.margin;
  const double left = 0.5 * (drawing.size[0] - legend.columns * column + style.margin);
  const double top = 0.5 * style.margin + static_cast<double>(rows) * legend.row;
  for (std::size_t n = 0; n < legend.rows.size(); ++n)
    draw_row(drawing, legend.rows[n],
             {left + static_cast<double>(n / rows) * column, top - (static_cast<double>(n % rows) + 0.5) * legend.row},
             series, style);
}

} // namespace signorini::view
