#include "view/heatmap.hpp"

#include "base/error.hpp"
#include "base/text.hpp"
#include "view/colorbar.hpp"
#include "view/legend.hpp"
#include "view/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::view {
namespace {

constexpr Rgb cell_rim = {70, 70, 70}, blank = {246, 246, 246};
constexpr double legible = 5; // minimum font size, pixels

// ── Checks ───────────────────────────────────────────────────────────────────────────────────────────────────────────

void check(const std::vector<Heat>& maps, const HeatmapOptions& options) {
  bool any = false;
  for (std::size_t m = 0; m < maps.size(); ++m) {
    const Message map = maps.size() > 1 ? Message("view.heatmap.map", {{"number", m}}) : Message();
    const MatrixX& values = maps[m].values;
    for (Eigen::Index row = 0; row < values.rows(); ++row)
      for (Eigen::Index column = 0; column < values.cols(); ++column) {
        const double value = values(row, column);
        if (!std::isfinite(value)) continue;
        any = true;
        require(!options.log || value > 0, "view.heatmap.log",
                {{"map", map}, {"row", row}, {"column", column}, {"value", value}});
      }
  }
  require(any, "view.heatmap.blank");
}

// ── Colors ──────────────────────────────────────────────────────────────────────────────────────────────────────────

struct Colors {
  std::array<double, 2> range{}, values{}; ///< of the bar, and of the drawn values
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

Colors make_colors(const std::vector<Heat>& maps, const HeatmapOptions& options) {
  Colors colors{{}, lowest_and_highest(maps), options.log, colormap(options.colormap)};
  const auto [low, high] = colors.values;
  if (options.log && !options.range) {
    const auto [from, to] = color_range({std::log10(low), std::log10(high)}, {}, false);
    colors.range = {std::min(low, std::pow(10, from)),
                    std::max(high, std::pow(10, to))}; // contains the values despite rounding error
    require_drawable(colors.range[0], colors.range[1], true);
  } else {
    colors.range = color_range(colors.values, options.range, is_diverging(options.colormap));
    require(!options.log || colors.range[0] > 0, "view.heatmap.range", {{"low", colors.range[0]}});
  }
  return colors;
}

/// None for categories.
std::optional<Colors> colors_of(const std::vector<Heat>& maps, const HeatmapOptions& options) {
  if (!options.categories.empty()) return std::nullopt;
  return make_colors(maps, options);
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
  std::vector<Frame> frames; ///< of the maps
  Frame whole;               ///< frame around all maps, for labels
  double map_title;          ///< size of the maps' titles
  double title_at;           ///< pixels: below the title, above everything else
  Legend legend;
  BarPlace bar;
};

/// Names at the centers of equal cells.
std::vector<Name> cell_names(const std::vector<std::string>& names) {
  std::vector<Name> result;
  for (const std::string& name : names) result.push_back({static_cast<double>(result.size()) + 0.5, name});
  return result;
}

int columns_for(std::size_t maps, const HeatmapOptions& options) {
  return std::min(static_cast<int>(maps), options.columns.value_or(maps == 4 ? 2 : 3));
}

HeatmapLayout lay_out(const std::vector<Heat>& maps, const HeatmapOptions& options, const std::optional<Colors>& colors,
                      const Style& style) {
  HeatmapLayout layout{};
  const int columns = columns_for(maps.size(), options);
  layout.map_title = 0.9 * style.label_size;
  const auto count = static_cast<int>(maps.size()), rows = (count + columns - 1) / columns;
  const auto across = static_cast<double>(options.x.size()), along = static_cast<double>(options.y.size());
  const double wide = options.size[0], high = options.size[1];
  const bool titled = std::any_of(maps.begin(), maps.end(), [](const Heat& map) { return !map.title.empty(); });
  const double head = titled ? 1.5 * layout.map_title : 0;
  const double top = high - style.margin - title_room(options.title, wide, style);

  double right = wide - 2 * style.margin;
  if (colors)
    right -= colorbar_room(colors->range, options.label, 0.8 * high, style, colors->log);
  else {
    layout.legend = make_legend(present(maps, options.categories), 0.42 * wide, 0.9 * (top - head), style);
    right -= layout.legend.width + 0.3 * style.margin;
  }
  // Circular dependency: names on the left depend on the height of cells, this on the names below, these on the width
  // of cells. The height is estimated first; smaller names then leave some space.
  const double row_gap = 0.8 * style.tick_size + head, column_gap = 1.2 * style.tick_size;
  const auto height_with = [&](double depth) {
    const double below = style.margin + room_below(style, options.xlabel) + depth;
    return (top - head - below - (rows - 1) * row_gap) / rows;
  };
  const auto names_at = [&](double height) {
    return stacked_names(cell_names(options.y), {0, along, false, 0, height}, 0.3 * wide, style);
  };
  Ticks yticks = names_at(height_with(0));
  const double left = style.margin + room_left(style, yticks, options.ylabel);
  const double width = (right - left - (columns - 1) * column_gap) / columns;
  require(width >= 0.1 * wide, "view.heatmap.width", {{"width", options.size[0]}, {"height", options.size[1]}});
  const Ticks xticks = named_ticks(cell_names(options.x), {0, across, false, 0, width}, 0.35 * high, style, true);
  const double height = height_with(xticks.depth);
  require(height >= 0.1 * high, "view.heatmap.height", {{"width", options.size[0]}, {"height", options.size[1]}});
  yticks = names_at(height);

  for (int m = 0; m < count; ++m) {
    const int column = m % columns, row = m / columns;
    const double x = left + column * (width + column_gap), y = top - head - row * (height + row_gap);
    Frame& frame = layout.frames.emplace_back();
    frame.box = {x, x + width, y - height, y};
    frame.x = {0, across, false, x, x + width};
    frame.y = {0, along, false, y - height, y};
    // Names only at the outer maps.
    if (column == 0) frame.yticks = yticks;
    if (m + columns >= count) frame.xticks = xticks;
  }
  layout.whole.box = {left, right, layout.frames.back().box[2], top - head};
  layout.title_at = top;
  layout.whole.xlabel = options.xlabel;
  layout.whole.ylabel = options.ylabel;
  layout.whole.xticks.depth = xticks.depth;
  layout.whole.yticks.names = yticks.names;
  layout.bar = {right + 1.3 * style.margin, layout.whole.box[2], top - head};
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

/// One font size for all texts, at which the longest one fits, but at least half of the size of numbers; texts that are
/// then too long are omitted. Zero if the cells are too low.
double text_size(const std::vector<Heat>& maps, const Box& cell, const Style& style) {
  double longest = 0;
  for (const Heat& map : maps)
    for (const auto& row : map.texts)
      for (const std::string& one : row) longest = std::max(longest, text_width(one, 1));
  const double least = std::max(0.5 * style.tick_size, legible), space = 0.88 * (cell[1] - cell[0]),
               high = 0.8 * (cell[3] - cell[2]);
  if (longest == 0 || high < least) return 0;
  return std::max(least, std::min({0.9 * style.tick_size, high, space / longest}));
}

void draw_text(Drawing& drawing, const std::string& string, const Box& cell, const Look& look, double size) {
  const double width = text_width(string, size), middle = 0.5 * (cell[0] + cell[1]), base = 0.5 * (cell[2] + cell[3]);
  if (string.empty() || size == 0 || width > 0.96 * (cell[1] - cell[0])) return;
  if (look.hatch != Hatch::none) { // hatch lines behind letters impair legibility
    const double margin = 0.2 * size;
    fill_box(drawing,
             {std::max(cell[0], middle - 0.5 * width - margin), std::min(cell[1], middle + 0.5 * width + margin),
              std::max(cell[2], base - 0.6 * size), std::min(cell[3], base + 0.6 * size)},
             look.color);
  }
  drawing.marks.push_back(Text{{middle, base - 0.36 * size}, string, size, Align::center, text_color(look.color)});
}

void draw_cells(Drawing& drawing, const Heat& map, const Cells& cells, const HeatmapOptions& options,
                const std::optional<Colors>& colors, double size, const Style& style) {
  const auto shown = [&](Eigen::Index j, Eigen::Index i) {
    const double value = map.values(j, i);
    if (!std::isfinite(value)) return Look{blank};
    return colors ? colors->look(value) : options.categories[static_cast<std::size_t>(value)].look;
  };
  constexpr double overlap = 0.6; // pixels beneath the next cell, to avoid seams
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
  if (line >= 0.5 * style.unit) { // only between cells that are large enough
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
  drawing.marks.push_back(Stroke{outline_of({left, right, bottom, top}), cell_rim, 1.6 * style.unit});
}

/// Ticks next to the cells that have names, if some have none.
void draw_ticks(Drawing& drawing, const Frame& frame, const HeatmapOptions& options, const Style& style) {
  const double length = 0.2 * style.tick_size, width = 1.6 * style.unit;
  const auto& [left, right, bottom, top] = frame.box;
  if (frame.xticks.at.size() < options.x.size())
    for (double at : frame.xticks.at)
      drawing.marks.push_back(Stroke{{{frame.x(at), bottom}, {frame.x(at), bottom - length}}, cell_rim, width});
  if (frame.yticks.at.size() < options.y.size())
    for (double at : frame.yticks.at)
      drawing.marks.push_back(Stroke{{{left, frame.y(at)}, {left - length, frame.y(at)}}, cell_rim, width});
}

Drawing draw(const std::vector<Heat>& maps, const HeatmapOptions& options) {
  const Style style = style_for(options.size);
  const std::optional<Colors> colors = colors_of(maps, options);
  const HeatmapLayout layout = lay_out(maps, options, colors, style);
  const auto columns = static_cast<Eigen::Index>(options.x.size()), rows = static_cast<Eigen::Index>(options.y.size());
  const double size = text_size(maps, Cells{layout.frames[0].box, columns, rows}(0, 0), style);

  Drawing drawing{options.size, {}};
  for (std::size_t m = 0; m < maps.size(); ++m) {
    const Box& box = layout.frames[m].box;
    draw_cells(drawing, maps[m], {box, columns, rows}, options, colors, size, style);
    if (!maps[m].title.empty())
      draw_fitting(drawing,
                   {{0.5 * (box[0] + box[1]), box[3] + 0.5 * layout.map_title},
                    maps[m].title,
                    layout.map_title,
                    Align::center,
                    ink},
                   box[1] - box[0], style);
    draw_ticks(drawing, layout.frames[m], options, style);
    draw_labels(drawing, layout.frames[m], style);
  }
  draw_labels(drawing, layout.whole, style);
  if (colors)
    draw_colorbar(drawing, layout.bar, colors->range, colors->values, colors->map, options.label, style, colors->log);
  else
    draw_legend(drawing, layout.legend, {}, {0, layout.whole.box[1], 0, layout.frames[0].box[3]}, style);
  draw_title(drawing, options.title, {layout.whole.box[0], layout.whole.box[1], 0, layout.title_at}, style);
  return drawing;
}

} // namespace

Figure heatmap_figure(const std::vector<Heat>& maps, const HeatmapOptions& options) {
  check(maps, options);
  return figure_of({draw(maps, options)});
}

std::vector<Spot> heatmap_spots(const std::vector<Heat>& maps, const HeatmapOptions& options) {
  check(maps, options);
  const HeatmapLayout layout = lay_out(maps, options, colors_of(maps, options), style_for(options.size));
  std::vector<Spot> spots;
  for (std::size_t m = 0; m < maps.size(); ++m) {
    const MatrixX& values = maps[m].values;
    const Cells cells{layout.frames[m].box, values.cols(), values.rows()};
    for (Eigen::Index j = 0; j < values.rows(); ++j)
      for (Eigen::Index i = 0; i < values.cols(); ++i) {
        const double value = values(j, i);
        if (!std::isfinite(value)) continue;
        const auto row = static_cast<std::size_t>(j), column = static_cast<std::size_t>(i);
        const bool named = !options.categories.empty();
        Spot& spot = spots.emplace_back(Spot{cells(j, i)});
        spot.add("", maps[m].title);
        spot.add(options.xlabel, options.x[column]);
        spot.add(options.ylabel, options.y[row]);
        spot.add(options.label, named ? options.categories[static_cast<std::size_t>(value)].name : text(value));
        if (named && !maps[m].texts.empty()) spot.add("", maps[m].texts[row][column]);
      }
  }
  return spots;
}

} // namespace signorini::view
