#include "view/chart.hpp"

#include "base/error.hpp"
#include "view/frame.hpp"
#include "view/markers.hpp"
#include "view/output.hpp"
#include "view/renderer.hpp"
#include "view/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::view {
namespace {

// Okabe and Ito's colours, which colour-blind readers tell apart; their yellow is too pale on white and gives way to
// brown.
constexpr Rgb palette[] = {{0, 114, 178},  {213, 94, 0},  {0, 158, 115}, {204, 121, 167},
                           {86, 180, 233}, {230, 159, 0}, {60, 60, 60},  {135, 75, 30}};
constexpr int palette_size = 8;

/// How a series looks. Grey prints tell lines apart by their few markers, and from the ninth on by dashes too.
struct Look {
  Rgb colour;
  int shape;
  bool sparse; ///< only a few markers along the line
  std::vector<double> dash;
};

Look look_of(const std::vector<Series>& series, std::size_t index, double unit) {
  const Series& s = series[index];
  Look look{palette[index % palette_size], static_cast<int>(index), !s.markers, {}};
  if (s.dashed || index / palette_size % 2 == 1) look.dash = {14 * unit, 9 * unit};
  return look;
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void take(double value) { low = std::min(low, value), high = std::max(high, value); }
};

bool drawn(const Series& s, std::size_t i) {
  return std::isfinite(s.x[i]) && std::isfinite(s.y[i]);
}

std::string name_of(const std::vector<Series>& series, std::size_t i) {
  return text("series ", i + 1, series[i].label.empty() ? "" : " '" + series[i].label + "'");
}

void check_positive(double value, char axis, const std::string& name) {
  require(value > 0, name, " has ", axis, " = ", value,
          " on a logarithmic axis, which shows only values above 0; leave '", axis, "' out of log or drop such points");
}

void check(const std::vector<Series>& series, const ChartOptions& options) {
  require(!series.empty(), "a chart needs at least one series, none came; give one such as { y = {1, 2, 3} }");
  bool any = false;
  for (std::size_t n = 0; n < series.size(); ++n) {
    const Series& s = series[n];
    require(s.x.size() == s.y.size(), name_of(series, n), " has ", s.x.size(), " x values and ", s.y.size(),
            " y values; give as many of one as of the other");
    require(s.line || s.markers, name_of(series, n), " has neither line nor markers; switch one of them on");
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      if (!drawn(s, i)) continue;
      any = true;
      if (options.log_x) check_positive(s.x[i], 'x', name_of(series, n));
      if (options.log_y) check_positive(s.y[i], 'y', name_of(series, n));
    }
  }
  require(any, "the chart's series hold no finite point; nothing can be drawn");
}

/// The given range, or the values' own with a little air; a single value, or values that only rounding tells apart, get
/// room on both sides.
Range axis_range(Range values, const std::optional<std::array<double, 2>>& given, bool log, char axis, double air) {
  if (given) {
    const auto [low, high] = *given;
    require(std::isfinite(low) && std::isfinite(high) && low < high && (!log || low > 0), "range of ", axis, " is ",
            low, " to ", high, "; expected finite numbers, the lower one first",
            log ? ", above 0 on a logarithmic axis" : "");
    return {low, high};
  }
  if (log) {
    const double factor = values.high / values.low < 1 + 1e-9 ? 2 : std::pow(values.high / values.low, air);
    return {values.low / factor, values.high * factor};
  }
  const double width = values.high - values.low;
  const double room = width > 1e-9 * std::max(std::abs(values.low), std::abs(values.high))
                          ? air * width
                          : std::max(0.1 * std::abs(values.high), 1e-9);
  return {values.low - room, values.high + room};
}

struct Legend {
  double size = 0, width = 0, row = 0;
  std::vector<std::string> labels;
};

double swatch(const Style& style) {
  return 70 * style.unit;
}

Legend make_legend(const std::vector<Series>& series, const ChartOptions& options, const Style& style, double height) {
  Legend legend;
  const bool single = series.size() == 1 && series[0].label.empty();
  if (!options.legend || single) return legend;
  double widest = 0;
  for (std::size_t n = 0; n < series.size(); ++n) {
    legend.labels.push_back(series[n].label.empty() ? text("series ", n + 1) : series[n].label);
    widest = std::max(widest, text_width(legend.labels.back(), 1.0));
  }
  const double room = 0.42 * options.size[0] - swatch(style);
  legend.size = std::min({style.label_size, height / (1.5 * series.size()), room / widest});
  require(legend.size >= 5, "the legend of ", series.size(), " series does not fit a chart of ", options.size[0], " × ",
          options.size[1], " pixels; choose shorter labels, a larger size, or legend = false");
  legend.row = 1.5 * legend.size;
  legend.width = swatch(style) + 0.5 * legend.size + widest * legend.size + style.margin;
  return legend;
}

void draw_sample(Drawing& drawing, const Series& s, const Look& look, const Vec2& from, const Vec2& to,
                 const Style& style) {
  if (s.line) drawing.marks.push_back(Stroke{{from, to}, look.colour, 3.4 * style.unit, look.dash});
  draw_marker(drawing, look.shape, {0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])}, 8.5 * style.unit, look.colour);
}

void draw_legend(Drawing& drawing, const Legend& legend, const std::vector<Series>& series, const Box& box,
                 const Style& style) {
  const double x = box[1] + style.margin;
  for (std::size_t n = 0; n < legend.labels.size(); ++n) {
    const double y = box[3] - (n + 0.5) * legend.row;
    draw_sample(drawing, series[n], look_of(series, n, style.unit), {x, y}, {x + swatch(style), y}, style);
    drawing.marks.push_back(Text{{x + swatch(style) + 0.5 * legend.size, y - 0.35 * legend.size},
                                 legend.labels[n],
                                 legend.size,
                                 Align::left,
                                 ink});
  }
}

/// The series' unbroken stretches in pixels; points closer than a fifth of a pixel to the last one are passed over.
std::vector<std::vector<Vec2>> stretches(const Series& s, const Frame& frame) {
  std::vector<std::vector<Vec2>> parts;
  bool open = false;
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    if (!drawn(s, i)) {
      open = false;
      continue;
    }
    const Vec2 point = {frame.x(s.x[i]), frame.y(s.y[i])};
    if (!open) parts.emplace_back();
    open = true;
    auto& part = parts.back();
    if (part.empty() || std::hypot(point[0] - part.back()[0], point[1] - part.back()[1]) > 0.2) part.push_back(point);
  }
  return parts;
}

bool within(const Vec2& p, const Box& box) {
  return p[0] >= box[0] - 0.5 && p[0] <= box[1] + 0.5 && p[1] >= box[2] - 0.5 && p[1] <= box[3] + 0.5;
}

/// All points, or about ten spread along the line, shifted from series to series so that they do not hide each other.
std::vector<Vec2> marker_places(const std::vector<Series>& series, std::size_t index, const Frame& frame, bool sparse) {
  const Series& s = series[index];
  std::vector<Vec2> places;
  for (std::size_t i = 0; i < s.x.size(); ++i)
    if (drawn(s, i)) places.push_back({frame.x(s.x[i]), frame.y(s.y[i])});
  std::erase_if(places, [&](const Vec2& p) { return !within(p, frame.box); });
  constexpr std::size_t few = 10;
  if (!sparse || places.size() <= 2 * few) return places;
  std::vector<Vec2> chosen;
  const double stride = static_cast<double>(places.size()) / few;
  for (std::size_t k = 0; k < few; ++k)
    chosen.push_back(places[static_cast<std::size_t>(stride * (k + (index + 0.5) / series.size()))]);
  return chosen;
}

void draw_series(Drawing& drawing, const std::vector<Series>& series, std::size_t index, const Frame& frame,
                 const Style& style) {
  const Series& s = series[index];
  const Look look = look_of(series, index, style.unit);
  if (s.line)
    for (const auto& stretch : stretches(s, frame))
      for (auto& part : clip_line(stretch, frame.box))
        drawing.marks.push_back(Stroke{std::move(part), look.colour, 3 * style.unit, look.dash});
  if (s.markers || (series.size() > 1 && s.line))
    for (const Vec2& place : marker_places(series, index, frame, look.sparse))
      draw_marker(drawing, look.shape, place, 8 * style.unit, look.colour);
}

Drawing lay_out(const std::vector<Series>& series, const ChartOptions& options) {
  const Style style = style_for(options.size);
  Range xs, ys;
  for (const Series& s : series)
    for (std::size_t i = 0; i < s.x.size(); ++i)
      if (drawn(s, i)) xs.take(s.x[i]), ys.take(s.y[i]);
  xs = axis_range(xs, options.xrange, options.log_x, 'x', 0.02);
  ys = axis_range(ys, options.yrange, options.log_y, 'y', 0.05);

  Drawing drawing{options.size, {}};
  Frame frame;
  frame.xlabel = options.xlabel;
  frame.ylabel = options.ylabel;
  const double bottom = style.margin + room_below(style, options.xlabel);
  const double height =
      options.size[1] - bottom - style.margin - (options.title.empty() ? 0.4 : 1.7) * style.title_size;
  frame.yticks = stacked_ticks(ys.low, ys.high, options.log_y, height, style);
  const double raised = frame.yticks.factor.empty() ? 0 : 1.2 * style.tick_size;
  const Legend legend = make_legend(series, options, style, height - raised);
  const double left = style.margin + room_left(style, frame.yticks, options.ylabel);
  const double right = options.size[0] - style.margin - std::max(legend.width, style.margin);
  const double top = bottom + height - raised;
  require(right - left >= 0.2 * options.size[0] && top - bottom >= 0.2 * options.size[1], "a chart of ",
          options.size[0], " × ", options.size[1],
          " pixels leaves too little room for the data beside labels and legend; choose a larger size");
  frame.box = {left, right, bottom, top};
  frame.x = {xs.low, xs.high, options.log_x, left, right};
  frame.y = {ys.low, ys.high, options.log_y, bottom, top};
  frame.xticks = fitting_ticks(xs.low, xs.high, options.log_x, right - left, style);

  draw_grid(drawing, frame, style);
  for (std::size_t n = series.size(); n-- > 0;) draw_series(drawing, series, n, frame, style);
  draw_frame(drawing, frame, style);
  draw_legend(drawing, legend, series, frame.box, style);
  draw_title(drawing, options.title, {left, right, bottom, top + raised}, style);
  return drawing;
}

} // namespace

void draw_chart(const std::vector<Series>& series, const ChartOptions& options, const std::string& file) {
  check(series, options);
  const std::string ending = file_ending(file);
  require(ending == ".png" || ending == ".svg" || ending == ".pdf", "file '", file,
          "' has no ending that charts know; expected .png, .svg or .pdf");
  const Drawing drawing = lay_out(series, options);
  write_whole(file, ending == ".png" ? png(drawing) : ending == ".svg" ? svg(drawing) : pdf(drawing));
}

} // namespace signorini::view
