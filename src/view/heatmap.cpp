#include "view/heatmap.hpp"

#include "base/error.hpp"
#include "base/whole_file.hpp"
#include "view/category_legend.hpp"
#include "view/cell_axes.hpp"
#include "view/colorbar.hpp"
#include "view/colormap.hpp"
#include "view/figure.hpp"
#include "view/text.hpp"
#include "view/ticks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::view {
namespace {

constexpr Rgb cell_rim = {70, 70, 70}, blank = {246, 246, 246};
constexpr double legible = 5; // pixels

// ── Checks ───────────────────────────────────────────────────────────────────────────────────────────────────────────

void check_value(double value, const HeatmapOptions& options, const std::string& where) {
  const auto count = static_cast<double>(options.categories.size());
  if (count > 0)
    require(value >= 0 && value < count && value == std::floor(value), where, " is ", value,
            "; expected the index of one of ", count, " categories");
  else if (options.log)
    require(value > 0, where, " is ", value,
            " on a logarithmic scale, which shows only values above 0; leave log out, or blank such cells with nan");
}

void check(const std::vector<Heat>& maps, const HeatmapOptions& options) {
  const auto columns = static_cast<Eigen::Index>(options.x.size()), rows = static_cast<Eigen::Index>(options.y.size());
  require(!maps.empty(), "a heat map needs values, none came");
  require(columns > 0 && rows > 0, "a heat map needs at least one x and one y, got ", columns, " and ", rows);
  bool any = false;
  for (std::size_t m = 0; m < maps.size(); ++m) {
    const std::string map = maps.size() > 1 ? text("map ", m + 1, ", ") : "";
    const MatrixX& values = maps[m].values;
    require(values.rows() == rows && values.cols() == columns, map, "values are ", values.rows(), " rows of ",
            values.cols(), "; expected ", rows, " rows, one per y, of ", columns, " values, one per x");
    for (Eigen::Index j = 0; j < rows; ++j)
      for (Eigen::Index i = 0; i < columns; ++i) {
        if (!std::isfinite(values(j, i))) continue;
        any = true;
        check_value(values(j, i), options, text(map, "values[", j + 1, "][", i + 1, "]"));
      }
    const auto& texts = maps[m].texts;
    require(texts.empty() || (texts.size() == options.y.size() &&
                              std::all_of(texts.begin(), texts.end(),
                                          [&](const auto& row) { return row.size() == options.x.size(); })),
            map, "texts do not match the cells; give ", rows, " rows of ", columns);
  }
  require(any, "the map's cells are all blank; nothing can be drawn");
  require(!options.columns || *options.columns >= 1, "columns is ", options.columns.value_or(1),
          "; a figure needs at least one");
}

// ── Colours ──────────────────────────────────────────────────────────────────────────────────────────────────────────

struct Colours {
  std::array<double, 2> range{}, values{}; ///< of the bar, and of what it shows
  bool log = false;
  std::vector<Rgb> map;

  Look look(double value) const {
    const Scale scale{range[0], range[1], log, 0, static_cast<double>(map.size() - 1)};
    return {map[static_cast<std::size_t>(std::lround(std::clamp(scale(value), scale.from, scale.to)))]};
  }
};

std::array<double, 2> lowest_and_highest(const std::vector<Heat>& maps) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Heat& map : maps)
    for (double value : map.values.reshaped())
      if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  return {low, high};
}

Colours make_colours(const std::vector<Heat>& maps, const HeatmapOptions& options) {
  Colours colours{{}, lowest_and_highest(maps), options.log, colormap(options.colormap)};
  const auto [low, high] = colours.values;
  if (options.log && !options.range) {
    const auto [from, to] = colour_range({std::log10(low), std::log10(high)}, {}, false);
    colours.range = {std::min(low, std::pow(10, from)), std::max(high, std::pow(10, to))}; // whatever rounding does
    require_drawable(colours.range[0], colours.range[1], true);
  } else {
    colours.range = colour_range(colours.values, options.range, is_diverging(options.colormap));
    require(!options.log || colours.range[0] > 0, "range begins at ", colours.range[0],
            " on a logarithmic scale; give a number above 0");
  }
  return colours;
}

std::vector<Category> present(const std::vector<Heat>& maps, const std::vector<Category>& categories) {
  std::vector<bool> found(categories.size());
  for (const Heat& map : maps)
    for (double value : map.values.reshaped())
      if (std::isfinite(value)) found[static_cast<std::size_t>(value)] = true;
  std::vector<Category> result;
  for (std::size_t c = 0; c < categories.size(); ++c)
    if (found[c]) result.push_back(categories[c]);
  return result;
}

// ── Layout ───────────────────────────────────────────────────────────────────────────────────────────────────────────

struct HeatmapLayout {
  std::vector<Box> boxes; ///< of the maps
  Box whole;
  int columns;
  CellNames below, beside;
  double map_title; ///< size of the maps' titles
  CategoryLegend legend;
  BarPlace bar;
};

int columns_for(std::size_t maps, const HeatmapOptions& options) {
  return std::min(static_cast<int>(maps), options.columns.value_or(maps == 4 ? 2 : 3));
}

HeatmapLayout lay_out(const std::vector<Heat>& maps, const HeatmapOptions& options,
                      const std::optional<Colours>& colours, const Style& style) {
  HeatmapLayout layout{};
  layout.columns = columns_for(maps.size(), options);
  layout.map_title = 0.9 * style.label_size;
  const auto count = static_cast<int>(maps.size()), rows = (count + layout.columns - 1) / layout.columns;
  const auto across = static_cast<double>(options.x.size()), along = static_cast<double>(options.y.size());
  const double wide = options.size[0], high = options.size[1];
  const bool titled = std::any_of(maps.begin(), maps.end(), [](const Heat& map) { return !map.title.empty(); });
  const double head = titled ? 1.5 * layout.map_title : 0;
  const double top = high - style.margin - title_room(options.title, wide, style);
  const double xlabel = options.xlabel.empty() ? 0.3 * style.label_size : 1.5 * style.label_size;
  const double ylabel = options.ylabel.empty() ? 0 : 1.4 * style.label_size;

  double right = wide - 2 * style.margin;
  if (colours)
    right -= colorbar_room(colours->range, options.label, 0.8 * high, style, colours->log);
  else {
    layout.legend = make_legend(present(maps, options.categories), 0.42 * wide, 0.9 * (top - head), style);
    right -= layout.legend.width + 0.3 * style.margin;
  }
  // The names beside depend on the cells' height, this on the names below, these on the cells' width: the height is
  // guessed first, and smaller names then leave a little air.
  const double row_gap = 0.8 * style.tick_size + head, column_gap = 1.2 * style.tick_size;
  const auto height_with = [&](double names) {
    return (top - head - style.margin - xlabel - names - (rows - 1) * row_gap) / rows;
  };
  const double most_beside = 0.3 * wide, most_below = 0.35 * high;
  layout.beside = names_beside(options.y, height_with(1.35 * style.tick_size) / along, most_beside, style);
  const double left = style.margin + ylabel + layout.beside.room;
  const double width = (right - left - (layout.columns - 1) * column_gap) / layout.columns;
  require(width >= 0.1 * wide, "a map of ", options.size[0], " × ", options.size[1],
          " pixels leaves too little room for its cells beside names and legend; choose a larger size");
  layout.below = names_below(options.x, width / across, most_below, style);
  const double height = height_with(layout.below.room);
  require(height >= 0.1 * high, "a map of ", options.size[0], " × ", options.size[1],
          " pixels leaves too little room for its cells above names and labels; choose a larger size");
  layout.beside = names_beside(options.y, height / along, layout.beside.room, style);

  for (int m = 0; m < count; ++m) {
    const int column = m % layout.columns, row = m / layout.columns;
    const double x = left + column * (width + column_gap), y = top - head - row * (height + row_gap);
    layout.boxes.push_back({x, x + width, y - height, y});
  }
  layout.whole = {left, right, layout.boxes.back()[2], top};
  layout.bar = {right + 1.3 * style.margin, layout.whole[2], top - head};
  return layout;
}

// ── Drawing ──────────────────────────────────────────────────────────────────────────────────────────────────────────

struct Cells {
  Box box;
  Eigen::Index columns, rows;

  Box operator()(Eigen::Index j, Eigen::Index i) const {
    const double width = (box[1] - box[0]) / columns, height = (box[3] - box[2]) / rows;
    return {box[0] + i * width, box[0] + (i + 1) * width, box[2] + j * height, box[2] + (j + 1) * height};
  }
};

/// One size for all texts: that at which the longest one fits, but no smaller than half of the numbers' size, at which
/// those that are too long are left out. None where the cells are too flat.
double text_size(const std::vector<Heat>& maps, const Box& cell, const Style& style) {
  double longest = 0;
  for (const Heat& map : maps)
    for (const auto& row : map.texts)
      for (const std::string& one : row) longest = std::max(longest, text_width(one, 1));
  const double least = std::max(0.5 * style.tick_size, legible), room = 0.88 * (cell[1] - cell[0]),
               high = 0.8 * (cell[3] - cell[2]);
  if (longest == 0 || high < least) return 0;
  return std::max(least, std::min({0.9 * style.tick_size, high, room / longest}));
}

void draw_text(Drawing& drawing, const std::string& string, const Box& cell, const Look& look, double size) {
  const double width = text_width(string, size), middle = 0.5 * (cell[0] + cell[1]), base = 0.5 * (cell[2] + cell[3]);
  if (string.empty() || size == 0 || width > 0.96 * (cell[1] - cell[0])) return;
  if (look.hatch != Hatch::none) { // lines behind letters make them hard to read
    const double air = 0.2 * size;
    fill_box(drawing,
             {std::max(cell[0], middle - 0.5 * width - air), std::min(cell[1], middle + 0.5 * width + air),
              std::max(cell[2], base - 0.6 * size), std::min(cell[3], base + 0.6 * size)},
             look.colour);
  }
  drawing.marks.push_back(Text{{middle, base - 0.36 * size}, string, size, Align::centre, text_colour(look.colour)});
}

void draw_cells(Drawing& drawing, const Heat& map, const Cells& cells, const HeatmapOptions& options,
                const std::optional<Colours>& colours, double size, const Style& style) {
  const auto shown = [&](Eigen::Index j, Eigen::Index i) {
    const double value = map.values(j, i);
    if (!std::isfinite(value)) return Look{blank};
    return colours ? colours->look(value) : options.categories[static_cast<std::size_t>(value)].look;
  };
  constexpr double overlap = 0.6; // pixels under the next cell, so that no seam shows between them
  for (Eigen::Index j = 0; j < cells.rows; ++j)
    for (Eigen::Index i = 0; i < cells.columns; ++i) {
      Box cell = cells(j, i);
      cell[1] += i + 1 < cells.columns ? overlap : 0;
      cell[3] += j + 1 < cells.rows ? overlap : 0;
      fill_cell(drawing, cell, shown(j, i), style);
    }
  const auto& [left, right, bottom, top] = cells.box;
  const Box first = cells(0, 0);
  const double line = std::min(2 * style.unit, 0.05 * std::min(first[1] - first[0], first[3] - first[2]));
  if (line >= 0.5 * style.unit) { // between cells that are not too small
    for (Eigen::Index i = 1; i < cells.columns; ++i)
      drawing.marks.push_back(Stroke{{{cells(0, i)[0], bottom}, {cells(0, i)[0], top}}, white, line});
    for (Eigen::Index j = 1; j < cells.rows; ++j)
      drawing.marks.push_back(Stroke{{{left, cells(j, 0)[2]}, {right, cells(j, 0)[2]}}, white, line});
  }
  for (std::size_t j = 0; j < map.texts.size(); ++j)
    for (std::size_t i = 0; i < map.texts[j].size(); ++i) {
      const auto row = static_cast<Eigen::Index>(j), column = static_cast<Eigen::Index>(i);
      draw_text(drawing, map.texts[j][i], cells(row, column), shown(row, column), size);
    }
  drawing.marks.push_back(
      Stroke{{{left, bottom}, {right, bottom}, {right, top}, {left, top}, {left, bottom}, {right, bottom}},
             cell_rim,
             1.6 * style.unit});
}

void draw_labels(Drawing& drawing, const HeatmapOptions& options, const HeatmapLayout& layout, const Style& style) {
  const auto& [left, right, bottom, top] = layout.whole;
  if (!options.xlabel.empty()) {
    const double y = bottom - layout.below.room - 1.05 * style.label_size;
    draw_fitting(drawing, {{0.5 * (left + right), y}, options.xlabel, style.label_size, Align::centre, ink},
                 right - left, style);
  }
  if (!options.ylabel.empty()) {
    const double x = left - layout.beside.room - 0.45 * style.label_size;
    const double high = layout.boxes.front()[3];
    draw_fitting(drawing, {{x, 0.5 * (bottom + high)}, options.ylabel, style.label_size, Align::centre, ink, true},
                 high - bottom, style);
  }
}

Drawing draw(const std::vector<Heat>& maps, const HeatmapOptions& options) {
  const Style style = style_for(options.size);
  std::optional<Colours> colours;
  if (options.categories.empty()) colours = make_colours(maps, options);
  const HeatmapLayout layout = lay_out(maps, options, colours, style);
  const auto columns = static_cast<Eigen::Index>(options.x.size()), rows = static_cast<Eigen::Index>(options.y.size());
  const double size = text_size(maps, Cells{layout.boxes[0], columns, rows}(0, 0), style);

  Drawing drawing{options.size, {}};
  for (std::size_t m = 0; m < maps.size(); ++m) {
    const Box& box = layout.boxes[m];
    draw_cells(drawing, maps[m], {box, columns, rows}, options, colours, size, style);
    if (!maps[m].title.empty())
      draw_fitting(drawing,
                   {{0.5 * (box[0] + box[1]), box[3] + 0.5 * layout.map_title},
                    maps[m].title,
                    layout.map_title,
                    Align::centre,
                    ink},
                   box[1] - box[0], style);
    // Names stand at the rim of the figure only.
    if (m % layout.columns == 0) draw_names_beside(drawing, layout.beside, box, style);
    if (m + layout.columns >= maps.size()) draw_names_below(drawing, layout.below, box, style);
  }
  draw_labels(drawing, options, layout, style);
  if (colours)
    draw_colorbar(drawing, layout.bar, colours->range, colours->values, colours->map, options.label, style,
                  colours->log);
  else
    draw_legend(drawing, layout.legend, {layout.whole[1] + style.margin, layout.boxes[0][3]}, style);
  draw_title(drawing, options.title, layout.whole, style);
  return drawing;
}

} // namespace

void draw_heatmap(const std::vector<Heat>& maps, const HeatmapOptions& options, const std::string& file) {
  check(maps, options);
  const Format format = format_of(file);
  write_whole(file, bytes_of(figure_of({draw(maps, options)}), format));
}

} // namespace signorini::view
