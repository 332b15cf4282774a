#include "view/legend.hpp"

#include "base/error.hpp"

#include <algorithm>

namespace signorini::view {
namespace {

constexpr Rgb rim = {70, 70, 70}, edge = {200, 200, 200};

/// One row per label and look. If some curves have labels, those without get no row.
std::vector<Legend::Row> rows_of(const std::vector<Series>& series, const Style& style) {
  std::vector<Legend::Row> rows;
  const bool labeled = std::any_of(series.begin(), series.end(), [](const Series& one) { return !one.label.empty(); });
  for (std::size_t n = 0; n < series.size(); ++n) {
    const auto known = [&](const Legend::Row& row) {
      return row.label == series[n].label && series[*row.series].line == series[n].line &&
             look_of(series, *row.series, style) == look_of(series, n, style);
    };
    if (!labeled)
      rows.push_back({text("series ", n + 1), n});
    else if (!series[n].label.empty() && std::none_of(rows.begin(), rows.end(), known))
      rows.push_back({series[n].label, n});
  }
  return rows;
}

/// The curves and their title, then the kinds of points and theirs.
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

bool has_sign(const Legend::Row& row) {
  return row.series || row.mark || row.look;
}

/// Indentation of a row's name, pixels.
double indent(const Legend& legend, const Legend::Row& row) {
  return has_sign(row) ? legend.sign + 0.45 * legend.size : 0;
}

/// Fits all names at a size into `space` pixels, each on at most `lines` lines; returns whether none is truncated.
bool fit_names(Legend& legend, double size, double space, int lines, const Style& style) {
  bool whole = true;
  legend.size = size;
  legend.row = 1.5 * size;
  for (Legend::Row& row : legend.rows) {
    row.text = fit_text(row.label, size, std::min(size, least_size(style)), space - indent(legend, row), lines);
    whole = whole && !row.text.cut;
  }
  return whole;
}

double widest(const Legend& legend) {
  double width = 0;
  for (const Legend::Row& row : legend.rows) width = std::max(width, indent(legend, row) + row.text.width());
  return width;
}

double height_of(const Legend& legend) {
  double height = 0;
  for (const Legend::Row& row : legend.rows) height += legend.row + row.text.depth();
  return height;
}

int rows_in(const Legend& legend, int columns) {
  return (static_cast<int>(legend.rows.size()) + columns - 1) / columns;
}

/// Right of the chart; returns whether no name is truncated.
bool put_in_columns(Legend& legend, double space, double height, const Style& style) {
  const double size = std::min(style.label_size, height / (1.5 * legend.rows.size()));
  if (size < least_size(style) || !fit_names(legend, size, space, 1, style)) return false;
  legend.width = widest(legend) + style.margin;
  return true;
}

double column_room(const ChartOptions& options, int columns, const Style& style) {
  return (options.size[0] - 2 * style.margin) / columns - style.margin;
}

/// Below the chart, with the number of columns for which names are largest; returns whether the rows fit.
bool put_below(Legend& legend, const ChartOptions& options, const Style& style) {
  const double most = 0.4 * options.size[1], least = least_size(style);
  const int count = std::ssize(legend.rows);
  legend.columns = 0;
  double best = 0;
  for (int columns = 1; columns <= count; ++columns) {
    const double size = std::min(0.9 * style.label_size, most / (1.5 * rows_in(legend, columns)));
    const double space = column_room(options, columns, style);
    if (size < least || space < legend.sign + 5 * least) continue;
    // Truncated names count as too small; at equal size fewer rows are preferred.
    const bool whole = fit_names(legend, size, space, 1, style);
    double score = whole ? size : 0.5 * least * space / options.size[0];
    for (const Legend::Row& row : legend.rows) score = whole && row.text.size < score ? row.text.size : score;
    if (score < 0.999 * best) continue;
    best = score;
    legend.columns = columns;
  }
  if (legend.columns == 0) return false;
  fit_names(legend, std::min(0.9 * style.label_size, most / (1.5 * rows_in(legend, legend.columns))),
            column_room(options, legend.columns, style), 1, style);
  legend.height = rows_in(legend, legend.columns) * legend.row + 0.5 * style.margin;
  return true;
}

/// Draws a row; `at`: its top left corner.
void draw_row(Drawing& drawing, const Legend& legend, const Legend::Row& row, const Vec2& at,
              const std::vector<Series>& series, const Style& style) {
  const double x = at[0], y = at[1] - 0.5 * legend.row;
  if (row.series)
    draw_sample(drawing, series[*row.series], look_of(series, *row.series, style), {x, y}, {x + legend.sign, y}, style);
  if (row.mark) draw_mark_sample(drawing, *row.mark, {x + 0.5 * legend.sign, y}, style);
  if (row.look) {
    const Box cell = {x, x + legend.sign, y - 0.58 * legend.size, y + 0.58 * legend.size};
    fill_cell(drawing, cell, *row.look, style);
    drawing.marks.push_back(Stroke{outline_of(cell), rim, 1.2 * style.unit});
  }
  draw_lines(drawing, row.text, {x + indent(legend, row), y - 0.35 * row.text.size}, Align::left, ink);
}

/// Draws one column of rows; `at`: its top left corner.
void draw_rows(Drawing& drawing, const Legend& legend, std::size_t first, std::size_t last, Vec2 at,
               const std::vector<Series>& series, const Style& style) {
  for (std::size_t n = first; n < std::min(last, legend.rows.size()); ++n) {
    draw_row(drawing, legend, legend.rows[n], at, series, style);
    at[1] -= legend.row + legend.rows[n].text.depth();
  }
}

Legend chart_legend(const std::vector<Series>& series, const ChartOptions& options, const Style& style) {
  Legend legend;
  legend.sign = 70 * style.unit;
  if (options.legend != LegendPlace::none) legend.rows = all_rows(series, options, style);
  return legend;
}

} // namespace

Legend make_legend(const std::vector<Series>& series, const ChartOptions& options, const Style& style, double height) {
  Legend legend = chart_legend(series, options, style);
  if (legend.rows.empty() || put_in_columns(legend, 0.42 * options.size[0], height, style)) return legend;
  require(put_below(legend, options, style), "view.legend.space",
          {{"rows", legend.rows.size()}, {"width", options.size[0]}, {"height", options.size[1]}});
  return legend;
}

std::optional<Legend> legend_within(const std::vector<Series>& series, const ChartOptions& options, const Box& frame,
                                    const Lines& lines, bool always, const Style& style) {
  const auto& [left, right, bottom, top] = frame;
  const double pad = 0.4 * style.label_size, margin = 0.5 * style.tick_size, gap = 12 * style.unit;
  Legend legend = chart_legend(series, options, style);
  if (legend.rows.empty() || !fit_names(legend, 0.9 * style.label_size, 0.5 * (right - left), 1, style))
    return std::nullopt;
  const double width = widest(legend) + 2 * pad, height = height_of(legend) + pad;
  if (width > 0.5 * (right - left) || height > 0.5 * (top - bottom)) return std::nullopt;
  double least = std::numeric_limits<double>::infinity();
  for (Corner corner : corners) {
    const Box box = corner_box(corner, {width, height}, frame, gap);
    const double hidden = covered(lines, enlarged(box, margin));
    if (hidden >= least || (hidden > 0 && !always)) continue;
    least = hidden;
    legend.within = box;
  }
  return legend.within ? std::optional(legend) : std::nullopt;
}

Legend make_legend(const std::vector<Category>& categories, double width, double height, const Style& style) {
  Legend legend;
  if (categories.empty()) return legend;
  for (const auto& [name, look] : categories) legend.rows.push_back({name, {}, {}, look});
  const double size = std::min(0.9 * style.label_size, height / (1.5 * static_cast<double>(categories.size())));
  require(size >= std::min(least_size(style), 5.0), "view.legend.categories", {{"count", categories.size()}});
  legend.sign = 1.5 * size;
  const auto fits = [&](double space) {
    return fit_names(legend, size, space, 3, style) && height_of(legend) <= height + 1e-6;
  };
  // Several lines are preferred to a legend half as wide as the figure.
  if (!fits(0.6 * width) && !fits(width)) fit_names(legend, size, width, 1, style);
  legend.width = widest(legend);
  return legend;
}

void draw_legend(Drawing& drawing, const Legend& legend, const std::vector<Series>& series, const Box& box,
                 const Style& style) {
  const std::size_t count = legend.rows.size();
  if (legend.within) {
    const double pad = 0.4 * style.label_size;
    fill_box(drawing, *legend.within, white);
    drawing.marks.push_back(Stroke{outline_of(*legend.within), edge, 1.4 * style.unit});
    draw_rows(drawing, legend, 0, count, {(*legend.within)[0] + pad, (*legend.within)[3] - 0.5 * pad}, series, style);
    return;
  }
  if (legend.height == 0) return draw_rows(drawing, legend, 0, count, {box[1] + style.margin, box[3]}, series, style);
  // Columns as narrow as their names, centered in the figure.
  const auto rows = static_cast<std::size_t>(rows_in(legend, legend.columns));
  const double column = widest(legend) + style.margin;
  const double left = 0.5 * (drawing.size[0] - legend.columns * column + style.margin);
  const double top = 0.5 * style.margin + static_cast<double>(rows) * legend.row;
  for (std::size_t c = 0; c * rows < count; ++c)
    draw_rows(drawing, legend, c * rows, (c + 1) * rows, {left + static_cast<double>(c) * column, top}, series, style);
}

} // namespace signorini::view
