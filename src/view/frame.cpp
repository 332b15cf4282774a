#include "view/frame.hpp"

#include "base/error.hpp"
#include "view/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::view {
namespace {

constexpr Rgb grid_color = {226, 226, 226}, minor_grid_color = {242, 242, 242}, axis_color = {70, 70, 70};
constexpr double digit_height = 0.72; // height of digits and capitals, relative to the font size

/// Tick marks inwards from the lower and the left side; lengths on x and on y in pixels.
void draw_ticks(Drawing& drawing, const Frame& frame, bool minor, const Vec2& lengths, const Rgb& color, double width) {
  const double left = frame.box[0], bottom = frame.box[2];
  for (double v : minor ? frame.xticks.minor : frame.xticks.at)
    drawing.marks.push_back(Stroke{{{frame.x(v), bottom}, {frame.x(v), bottom + lengths[0]}}, color, width});
  for (double v : minor ? frame.yticks.minor : frame.yticks.at)
    drawing.marks.push_back(Stroke{{{left, frame.y(v)}, {left + lengths[1], frame.y(v)}}, color, width});
}

double widest(const Ticks& ticks, double size) {
  double width = 0;
  if (ticks.names.empty())
    for (const std::string& label : ticks.labels) width = std::max(width, text_width(label, size));
  for (const FittedText& name : ticks.names) width = std::max(width, name.width());
  return width;
}

/// Removes ticks until numbers do not overlap; on a log axis removed ones become minor ticks. `needed(i)`: minimum
/// distance of ticks i − 1 and i.
template <class Needed> void thin_out(Ticks& ticks, const Scale& scale, Needed needed) {
  for (std::size_t i = 1; i < ticks.at.size();) {
    if (scale(ticks.at[i]) - scale(ticks.at[i - 1]) >= needed(i)) {
      ++i;
      continue;
    }
    if (scale.log) ticks.minor.push_back(ticks.at[i]);
    ticks.at.erase(ticks.at.begin() + static_cast<std::ptrdiff_t>(i));
    ticks.labels.erase(ticks.labels.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

/// Draws a name below a point of the frame's lower side, or left of a point of its left side.
void draw_name(Drawing& drawing, const FittedText& name, const Vec2& at, bool upright, bool at_left,
               const Style& style) {
  const double tick = style.tick_size, middle = 0.5 * (digit_height * name.size - name.depth());
  const Vec2 start = upright   ? Vec2{at[0] + middle, at[1] - 0.5 * tick}
                     : at_left ? Vec2{at[0] - 0.45 * tick, at[1] - middle}
                               : Vec2{at[0], at[1] - 1.2 * tick};
  draw_lines(drawing, name, start, upright || at_left ? Align::right : Align::center, ink, upright);
}

/// Fits a title into `above` pixels over the box.
FittedText fit_title(const std::string& title, double space, double above, const Style& style) {
  const double full = style.title_size;
  FittedText fitted;
  for (int most = 3; most >= 1; --most) {
    fitted = fit_text(title, full, std::max(0.6 * full, least_size(style)), space, most);
    if (1.5 * full + fitted.depth() <= above + 1e-6) break;
  }
  return fitted;
}

Ticks make_ticks(double low, double high, bool log, int count) {
  return log ? log_ticks(low, high, count) : linear_ticks(low, high, count);
}

} // namespace

Style style_for(const std::array<int, 2>& size) {
  require(size[0] >= 160 && size[1] >= 120 && size[0] <= 5000 && size[1] <= 5000, "view.frame.size",
          {{"width", size[0]}, {"height", size[1]}});
  // Small figures have relatively larger text, for legibility.
  const double scale = std::min(size[0] / 1600.0, size[1] / 1000.0), unit = scale < 1 ? std::pow(scale, 0.75) : scale;
  return {unit, 27 * unit, 30 * unit, 34 * unit, 26 * unit};
}

double least_size(const Style& style) {
  return 18 * style.unit;
}

double Scale::operator()(double value) const {
  const double t = log ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
  return from + t * (to - from);
}

double room_below(const Style& style, const std::string& label) {
  return 1.45 * style.tick_size + (label.empty() ? 0.0 : 1.5 * style.label_size);
}

double room_left(const Style& style, const Ticks& ticks, const std::string& label) {
  return widest(ticks, style.tick_size) + 0.55 * style.tick_size + (label.empty() ? 0.0 : 1.4 * style.label_size);
}

Ticks fitting_ticks(double low, double high, bool log, double pixels, const Style& style) {
  const Scale scale{low, high, log, 0, pixels};
  Ticks ticks;
  const auto needed = [&](std::size_t i) {
    const double widths =
        text_width(ticks.labels[i - 1], style.tick_size) + text_width(ticks.labels[i], style.tick_size);
    return 0.5 * widths + 0.8 * style.tick_size;
  };
  for (int count = 9; count >= 2; --count) {
    ticks = make_ticks(low, high, log, count);
    bool fits = true;
    for (std::size_t i = 1; i < ticks.at.size() && fits; ++i)
      fits = scale(ticks.at[i]) - scale(ticks.at[i - 1]) > needed(i);
    if (fits) return ticks;
  }
  thin_out(ticks, scale, needed);
  return ticks;
}

Ticks stacked_ticks(double low, double high, bool log, double pixels, const Style& style) {
  Ticks ticks = make_ticks(low, high, log, std::clamp(static_cast<int>(pixels / (2.6 * style.tick_size)), 2, 9));
  thin_out(ticks, {low, high, log, 0, pixels}, [&](std::size_t) { return 1.1 * style.tick_size; });
  return ticks;
}

std::array<double, 2> reach_of_ticks(const Frame& frame, const Style& style) {
  const Ticks& ticks = frame.xticks;
  std::array<double, 2> reach = {frame.box[0], frame.box[1]};
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    const double width = ticks.names.empty() ? text_width(ticks.labels[i], style.tick_size) : ticks.names[i].width();
    const double half = 0.5 * (ticks.upright ? ticks.names[i].size : width), at = frame.x(ticks.at[i]);
    reach = {std::min(reach[0], at - half), std::max(reach[1], at + half)};
  }
  return reach;
}

void fill_box(Drawing& drawing, const Box& box, const Rgb& color) {
  const auto& [left, right, bottom, top] = box;
  drawing.marks.push_back(Fill{{{left, bottom}, {right, bottom}, {right, top}, {left, top}}, color});
}

void draw_grid(Drawing& drawing, const Frame& frame, const Style& style) {
  const Vec2 across = {frame.box[3] - frame.box[2], frame.box[1] - frame.box[0]};
  draw_ticks(drawing, frame, true, across, minor_grid_color, 1.4 * style.unit);
  draw_ticks(drawing, frame, false, across, grid_color, 1.4 * style.unit);
}

void draw_frame(Drawing& drawing, const Frame& frame, const Style& style) {
  const double width = 1.6 * style.unit, tick = 9 * style.unit;
  drawing.marks.push_back(Stroke{outline_of(frame.box), axis_color, width});
  draw_ticks(drawing, frame, true, {0.5 * tick, 0.5 * tick}, axis_color, width);
  draw_ticks(drawing, frame, false, {tick, tick}, axis_color, width);
  draw_labels(drawing, frame, style);
}

void draw_labels(Drawing& drawing, const Frame& frame, const Style& style) {
  const auto& [left, right, bottom, top] = frame.box;
  const double size = style.tick_size;
  const auto name_of = [&](const Ticks& ticks, std::size_t i) {
    return ticks.names.empty() ? FittedText{{ticks.labels[i]}, size} : ticks.names[i];
  };
  for (std::size_t i = 0; i < frame.xticks.at.size(); ++i)
    draw_name(drawing, name_of(frame.xticks, i), {frame.x(frame.xticks.at[i]), bottom}, frame.xticks.upright, false,
              style);
  for (std::size_t i = 0; i < frame.yticks.at.size(); ++i)
    draw_name(drawing, name_of(frame.yticks, i), {left, frame.y(frame.yticks.at[i])}, false, true, style);
  if (!frame.yticks.factor.empty())
    drawing.marks.push_back(Text{{left, top + 0.4 * size}, frame.yticks.factor, size, Align::left, ink});

  const double label_base = bottom - 1.45 * size - 1.05 * style.label_size - frame.xticks.depth;
  const double factor = frame.xticks.factor.empty() ? 0 : text_width(frame.xticks.factor, size) + 0.5 * size;
  if (!frame.xlabel.empty())
    draw_fitting(drawing, {{0.5 * (left + right), label_base}, frame.xlabel, style.label_size, Align::center, ink},
                 right - left - 2 * factor, style);
  // The common factor is at the end of the axis, in the row of the label, or in the row of numbers if there is no
  // label.
  if (!frame.xticks.factor.empty())
    drawing.marks.push_back(Text{{right, frame.xlabel.empty() ? bottom - 2.4 * size : label_base},
                                 frame.xticks.factor,
                                 size,
                                 Align::right,
                                 ink});
  if (!frame.ylabel.empty()) {
    const double at = left - 0.55 * size - widest(frame.yticks, size) - 0.45 * style.label_size;
    draw_fitting(drawing, {{at, 0.5 * (bottom + top)}, frame.ylabel, style.label_size, Align::center, ink, true},
                 top - bottom, style);
  }
}

double title_room(const std::string& title, double figure_width, const Style& style) {
  if (title.empty()) return 0.4 * style.title_size;
  const double space = figure_width - 2 * style.margin;
  return 1.7 * style.title_size + fit_title(title, space, std::numeric_limits<double>::infinity(), style).depth();
}

void draw_title(Drawing& drawing, const std::string& title, const Box& box, const Style& style) {
  if (title.empty()) return;
  const double space = drawing.size[0] - 2 * style.margin;
  const FittedText fitted = fit_title(title, space, drawing.size[1] - box[3], style);
  const double half = 0.5 * fitted.width();
  const double center = std::clamp(0.5 * (box[0] + box[1]), style.margin + half, drawing.size[0] - style.margin - half);
  draw_lines(drawing, fitted, {center, box[3] + 0.7 * style.title_size + fitted.depth()}, Align::center, black);
}

void draw_lines(Drawing& drawing, const FittedText& text, Vec2 at, Align align, const Rgb& color, bool upright) {
  for (const std::string& line : text.lines) {
    if (!line.empty()) drawing.marks.push_back(Text{at, line, text.size, align, color, upright});
    at = at + (upright ? Vec2{line_step * text.size, 0} : Vec2{0, -line_step * text.size});
  }
}

void draw_fitting(Drawing& drawing, Text text, double space, const Style& style) {
  const FittedText fitted = fit_text(text.string, text.size, std::min(text.size, least_size(style)), space);
  text.string = fitted.lines.front();
  text.size = fitted.size;
  drawing.marks.emplace_back(std::move(text));
}

double fitting_size(const std::string& text, double wanted, double space) {
  return std::min(wanted, wanted * space / std::max(text_width(text, wanted), 1.0));
}

} // namespace signorini::view
