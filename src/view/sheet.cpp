#include "view/sheet.hpp"

#include "base/error.hpp"
#include "view/camera.hpp"
#include "view/colorbar.hpp"
#include "view/text.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::view {
namespace {

using Interval = std::array<double, 2>;

Interval joined(const Interval& a, const Interval& b) {
  return {std::min(a[0], b[0]), std::max(a[1], b[1])};
}
double length(const Interval& interval) {
  return interval[1] - interval[0];
}

/// The arrangement of states in rows: ranges of x, and of y by row.
struct Grid {
  int columns = 0;
  Interval x{};
  std::vector<Interval> y;

  double rows() const { return static_cast<double>(y.size()); }
  double height() const {
    double sum = 0;
    for (const Interval& row : y) sum += length(row);
    return sum;
  }
};

Grid make_grid(const ModelBoxes& boxes, int columns) {
  Grid grid{columns, {boxes[0][0], boxes[0][1]}, {}};
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Box& b = boxes[i];
    grid.x = joined(grid.x, {b[0], b[1]});
    if (i % columns == 0)
      grid.y.push_back({b[2], b[3]});
    else
      grid.y.back() = joined(grid.y.back(), {b[2], b[3]});
  }
  return grid;
}

/// The bar of the range, if there is one, and those of adjacent pictures.
std::vector<Bar> bars_of(const PictureOptions& options, const std::optional<Interval>& range) {
  if (!range) return {};
  std::vector<Bar> bars = options.adjacent_bars;
  bars.push_back({*range, options.field_label});
  return bars;
}

/// Space around and between the states, pixels.
struct Spacing {
  double title;                   ///< above all
  double head;                    ///< above each row
  double below;                   ///< numbers and label of x
  double left;                    ///< numbers and label of y
  double right;                   ///< color bar, or margin
  double across;                  ///< between columns
  double between;                 ///< between rows, without `head`
  double free_width, free_height; ///< left for the states
};

double key_room(const Style& style) {
  return 1.6 * style.tick_size;
}

Spacing spacing_of(const Grid& grid, const std::vector<std::string>& titles, const PictureOptions& options,
                   const std::optional<Interval>& range, const Style& style, const std::optional<ArrowRoom>& arrows) {
  const bool titled = std::any_of(titles.begin(), titles.end(), [](const std::string& t) { return !t.empty(); });
  const double width = options.size[0], height = options.size[1];
  Spacing spaces{};
  spaces.title = (options.title.empty() ? 0.4 : 1.7) * style.title_size;
  spaces.below = !arrows         ? room_below(style, axis_name(options, 0, options.unit))
                 : options.ruler ? ruler_room(style)
                                 : 0;
  if (!options.vectors.empty()) spaces.below += key_room(style);
  // Numbers depend little on the final size of the states.
  const double guess = (height - 2 * style.margin - spaces.title - spaces.below) / grid.rows();
  bool factor = false;
  if (arrows) spaces.left = arrows->width;
  for (const auto& [low, high] : arrows ? std::vector<Interval>() : grid.y) {
    const Ticks ticks = stacked_ticks(low, high, false, guess, style);
    spaces.left = std::max(spaces.left, room_left(style, ticks, axis_name(options, 1, options.unit)));
    factor |= !ticks.factor.empty();
  }
  spaces.head = (factor ? 1.2 * style.tick_size : 0) + (titled ? 1.5 * style.label_size : 0);
  spaces.right = range ? 0 : 2 * style.margin;
  for (const Bar& bar : bars_of(options, range))
    spaces.right =
        std::max(spaces.right, style.margin + colorbar_room(bar.range, bar.title, guess * grid.rows(), style));
  double number = 0;
  if (!arrows)
    for (const std::string& label : fitting_ticks(grid.x[0], grid.x[1], false, width / grid.columns, style).labels)
      number = std::max(number, text_width(label, style.tick_size));
  spaces.across = std::max(1.5 * style.tick_size, number + 0.5 * style.tick_size);
  spaces.between = 0.7 * style.tick_size;
  spaces.free_width = width - style.margin - spaces.left - spaces.right - (grid.columns - 1) * spaces.across;
  spaces.free_height = height - 2 * style.margin - spaces.title - spaces.below - grid.rows() * spaces.head -
                       (grid.rows() - 1) * spaces.between;
  return spaces;
}

/// Pixels per unit of length.
double scale_of(const Grid& grid, const Spacing& spaces) {
  return std::min(spaces.free_width / (grid.columns * length(grid.x)), spaces.free_height / grid.height());
}

void clear_numbers(Ticks& ticks) {
  ticks.factor.clear();
  for (std::string& number : ticks.labels) number.clear();
}

std::vector<Frame> make_frames(const Grid& grid, const Spacing& spaces, double scale, double left, double top,
                               std::size_t count, bool numbers, const PictureOptions& options, const Style& style) {
  std::vector<Frame> frames;
  const double width = scale * length(grid.x);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t column = i % grid.columns;
    const Interval& y = grid.y[i / grid.columns];
    if (column == 0 && i > 0) top -= scale * length(grid.y[i / grid.columns - 1]) + spaces.between + spaces.head;
    const double bottom = top - scale * length(y), start = left + column * (width + spaces.across);
    Frame frame;
    frame.box = {start, start + width, bottom, top};
    frame.x = {grid.x[0], grid.x[1], false, start, start + width};
    frame.y = {y[0], y[1], false, bottom, top};
    if (!numbers) {
      frames.push_back(std::move(frame));
      continue;
    }
    frame.xticks = fitting_ticks(grid.x[0], grid.x[1], false, width, style);
    frame.yticks = stacked_ticks(y[0], y[1], false, top - bottom, style);
    // Numbers only at the outer states.
    if (i + grid.columns >= count)
      frame.xlabel = axis_name(options, 0, options.unit);
    else
      clear_numbers(frame.xticks);
    if (column == 0)
      frame.ylabel = axis_name(options, 1, options.unit);
    else
      clear_numbers(frame.yticks);
    frames.push_back(std::move(frame));
  }
  return frames;
}

/// An arrow of a round length with its label.
void draw_key(Canvas& canvas, const PictureOptions& options) {
  const Style& style = canvas.style;
  const double size = style.tick_size, y = canvas.sheet.key[1] + 0.55 * size;
  Vec2 at = {canvas.sheet.key[0], y};
  std::string words = options.vectors + ": all zero";
  if (canvas.vector_scale > 0) {
    const double length = round_below(1.15 * vector_step(style) / canvas.vector_scale);
    words = options.vectors + " " + in_digits(length) + (options.vector_unit.empty() ? "" : " " + options.vector_unit);
    draw_vectors(canvas.plate.drawing, {{{at[0], y, 0}, {length, 0, 0}}}, canvas.vector_scale,
                 {0, 1.0 * canvas.sheet.size[0], 0, 1.0 * canvas.sheet.size[1]}, style.unit);
    at[0] += canvas.vector_scale * length + 0.5 * size;
  }
  draw_fitting(canvas.plate.drawing, {{at[0], y - 0.36 * size}, words, size, Align::left, ink},
               canvas.sheet.size[0] - style.margin - at[0], style);
}

ModelBoxes widened(ModelBoxes boxes, const PictureOptions& options) {
  if (options.extent)
    for (Box& box : boxes) box = hull({box, *options.extent});
  return boxes;
}

} // namespace

Sheet lay_out_sheet(const std::vector<std::string>& titles, const ModelBoxes& boxes, const PictureOptions& options,
                    const std::optional<std::array<double, 2>>& range, const Style& style,
                    const std::optional<ArrowRoom>& arrows) {
  const int count = std::ssize(titles);
  Grid grid;
  Spacing spaces{};
  double scale = -1;
  const int most = std::min(options.columns.value_or(count), count);
  for (int columns = options.columns ? most : 1; columns <= most; ++columns) {
    const Grid next = make_grid(boxes, columns);
    const Spacing needed = spacing_of(next, titles, options, range, style, arrows);
    if (scale_of(next, needed) > scale * (1 + 1e-9)) grid = next, spaces = needed, scale = scale_of(next, needed);
  }
  require(scale > 0 && spaces.free_width > 0.2 * options.size[0] && spaces.free_height > 0.2 * options.size[1],
          "view.sheet.space", {{"width", options.size[0]}, {"height", options.size[1]}});

  const double width = grid.columns * scale * length(grid.x) + (grid.columns - 1) * spaces.across;
  const double height = scale * grid.height() + (grid.rows() - 1) * (spaces.between + spaces.head);
  // For states of small height the bar extends above and below them.
  double bar = height;
  for (const Bar& one : bars_of(options, range)) {
    const double least = std::max(9 * style.tick_size, 0.8 * text_width(one.title, style.label_size));
    bar = std::max(bar, std::min(least, spaces.free_height));
  }
  const double low = arrows ? 0.5 * arrows->height : 0;
  const double up = std::max({0.5 * height + spaces.head, 0.5 * bar, low}),
               down = std::max({0.5 * height + spaces.below, 0.5 * bar, low});
  const double wide = style.margin + spaces.left + width + spaces.right;
  const double high = 2 * style.margin + spaces.title + up + down;
  const double title = text_width(options.title, style.title_size) + 2 * style.margin;

  Sheet sheet;
  sheet.size = options.size;
  if (options.trim) {
    const auto cut = [](double need, int least, int most) {
      return std::clamp(static_cast<int>(std::ceil(need - 1e-6)), std::min(least, most), most);
    };
    sheet.size = {cut(std::max(wide, title), 160, options.size[0]), cut(high, 120, options.size[1])};
  }
  const double left = 0.5 * (sheet.size[0] - wide) + style.margin + spaces.left;
  const double middle = 0.5 * (sheet.size[1] - high) + style.margin + down, top = middle + 0.5 * height;
  sheet.frames = make_frames(grid, spaces, scale, left, top, titles.size(), !arrows, options, style);
  sheet.panel_title_size = 0.9 * style.label_size;
  for (const std::string& one : titles)
    sheet.panel_title_size = fitting_size(one, sheet.panel_title_size, scale * length(grid.x));
  sheet.arrows = {left - spaces.left, std::min(middle - 0.5 * height, middle - low)};
  sheet.key = {left, middle - 0.5 * height - spaces.below};
  sheet.bar = {left + width + 1.3 * style.margin, middle - 0.5 * bar, middle + 0.5 * bar};
  sheet.whole = {left, left + width, middle - 0.5 * height, middle + up};
  return sheet;
}

Canvas make_canvas(const std::vector<std::string>& titles, const ModelBoxes& boxes,
                   const std::vector<const VectorX*>& values, double longest, const PictureOptions& options,
                   const std::optional<ArrowRoom>& arrows) {
  Canvas canvas{style_of(options), colormap(options.colormap), colored_values(values), {0, 1}, {}, 0, {}, {}};
  if (canvas.values) canvas.range = color_range(*canvas.values, options);
  if (canvas.values && options.contours)
    canvas.levels = contour_levels(*options.contours, canvas.range, canvas.values->all);
  const double most = std::max(options.longest_vector, longest);
  if (most > 0) canvas.vector_scale = 1.15 * vector_step(canvas.style) / most;
  const auto shown = canvas.values && options.bar ? std::optional(canvas.range) : std::nullopt;
  canvas.sheet = lay_out_sheet(titles, widened(boxes, options), options, shown, canvas.style, arrows);
  canvas.plate.drawing.size = canvas.sheet.size;
  canvas.plate.frames = canvas.sheet.frames;
  return canvas;
}

double vector_step(const Style& style) {
  return 60 * style.unit;
}

Plate finished(Canvas canvas, const PictureOptions& options) {
  Drawing& drawing = canvas.plate.drawing;
  if (canvas.values && options.bar)
    draw_colorbar(drawing, canvas.sheet.bar, canvas.range, canvas.values->all, canvas.colors, options.field_label,
                  canvas.style, false, canvas.levels);
  if (!options.vectors.empty()) draw_key(canvas, options);
  draw_title(drawing, options.title, canvas.sheet.whole, canvas.style);
  return std::move(canvas.plate);
}

std::array<double, 2> color_range(const ColoredValues& values, const PictureOptions& options) {
  return color_range(values, options.range, is_diverging(options.colormap), options.field_label);
}

std::string axis_name(const PictureOptions& options, int axis, const std::string& unit) {
  if (!options.axis_names) return "";
  if (!options.axes.empty()) return options.axes[static_cast<std::size_t>(axis)];
  return std::string(1, "xyz"[axis]) + (unit.empty() ? "" : " (" + unit + ")");
}

Style style_of(const PictureOptions& options) {
  const Style own = style_for(options.size);
  return options.style.value_or(own);
}

Box hull(const ModelBoxes& boxes) {
  Box all = boxes.front();
  for (const Box& box : boxes)
    all = {std::min(all[0], box[0]), std::max(all[1], box[1]), std::min(all[2], box[2]), std::max(all[3], box[3])};
  return all;
}

} // namespace signorini::view
