#include "view/colorbar.hpp"

#include "base/error.hpp"
#include "base/warning.hpp"
#include "view/surface_lines.hpp"
#include "view/text.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

namespace signorini::view {
namespace {

constexpr Rgb bar_rim = {70, 70, 70};

double bar_width(const Style& style) {
  return 30 * style.unit;
}

double widest_tick(const Ticks& ticks, double size) {
  double width = text_width(ticks.factor, size) - 0.5 * size; // the factor is above the bar itself
  for (const std::string& label : ticks.labels) width = std::max(width, text_width(label, size));
  return width;
}

/// True if values between these differ by more than rounding error.
bool differ(const std::array<double, 2>& values) {
  return values[1] - values[0] > 1e-9 * std::max(std::abs(values[0]), std::abs(values[1]));
}

/// The range of colors of values that do not differ, which says nothing about them.
std::array<double, 2> widened(const std::array<double, 2>& values) {
  const double size = std::max(std::abs(values[0]), std::abs(values[1])), space = size == 0 ? 1 : 0.1 * size;
  return {values[0] - space, values[1] + space};
}

} // namespace

std::optional<ColoredValues> colored_values(const std::vector<const VectorX*>& values) {
  std::vector<double> sorted;
  for (const VectorX* some : values)
    std::ranges::copy_if(*some, std::back_inserter(sorted), [](double value) { return !std::isnan(value); });
  if (sorted.empty()) return std::nullopt;
  constexpr double share = 0.005, far = 3;
  const auto left_out = static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(sorted.size())));
  const auto [least, most] = std::minmax_element(sorted.begin(), sorted.end());
  ColoredValues result{{*least, *most}, {*least, *most}, sorted.size()};
  if (2 * left_out >= static_cast<std::ptrdiff_t>(sorted.size())) return result;
  const auto first = sorted.begin() + left_out, last = sorted.end() - 1 - left_out;
  std::nth_element(sorted.begin(), first, sorted.end());
  const double low = *first;
  std::nth_element(sorted.begin(), last, sorted.end());
  const double high = *last, width = far * (high - low);
  if (!(width > 0)) return result;
  if (low - result.all[0] > width) result.typical[0] = low;
  if (result.all[1] - high > width) result.typical[1] = high;
  result.extreme = static_cast<std::size_t>(std::count_if(sorted.begin(), sorted.end(), [&](double value) {
    return value < result.typical[0] || value > result.typical[1];
  }));
  return result;
}

std::array<double, 2> color_range(const ColoredValues& values, const std::optional<std::array<double, 2>>& given,
                                  bool diverging, const std::string& title) {
  const auto range = color_range(values.typical, given, diverging);
  if (!given && values.clipped())
    warn("view.colors.outliers", {{"title", title},
                                  {"count", values.extreme},
                                  {"samples", values.count},
                                  {"low", values.all[0]},
                                  {"high", values.all[1]}});
  return range;
}

std::array<double, 2> color_range(const std::array<double, 2>& values,
                                  const std::optional<std::array<double, 2>>& given, bool diverging) {
  if (given) {
    require_drawable((*given)[0], (*given)[1], false);
    return *given;
  }
  auto [low, high] = values;
  if (diverging && low < 0 && high > 0) high = std::max(-low, high), low = -high;
  if (!differ({low, high})) return widened({low, high});
  require_drawable(low, high, false);
  return {low, high};
}

double colorbar_room(const std::array<double, 2>& range, const std::string& title, double height, const Style& style,
                     bool log) {
  const Ticks ticks = stacked_ticks(range[0], range[1], log, height, style);
  return 1.3 * style.margin + bar_width(style) + 0.5 * style.tick_size + widest_tick(ticks, style.tick_size) +
         (title.empty() ? 0.0 : 1.6 * style.label_size);
}

void draw_colorbar(Drawing& drawing, const BarPlace& place, const std::array<double, 2>& range,
                   const std::array<double, 2>& values, const std::vector<Rgb>& colors, const std::string& title,
                   const Style& style, bool log, const std::vector<double>& levels) {
  const double width = bar_width(style), right = place.left + width, size = style.tick_size, point = 0.8 * width;
  const std::array<bool, 2> beyond = {values[0]<range[0], values[1]> range[1]};
  // Minimum and maximum of the values are printed below and above the bar, the common factor between them.
  const double line = 1.35 * size, bottom = place.bottom + line, top = place.top - line;
  const Ticks ticks = stacked_ticks(range[0], range[1], log, top - bottom, style);
  const double room_above = ticks.factor.empty() ? 0 : 1.45 * size;
  const double low = bottom + (beyond[0] ? point : 0), high = top - room_above - (beyond[1] ? point : 0);
  const double middle = 0.5 * (place.left + right);
  const Scale scale{range[0], range[1], log, low, high};

  const bool constant = !log && !differ(values) && range == widened(values);
  const std::vector<Rgb> shown = constant ? std::vector{color_of(values[0], range, colors)} : colors;
  const double step = (high - low) / static_cast<double>(shown.size());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const double from = low + step * i; // each up to the top, to avoid seams
    drawing.marks.push_back(Fill{{{place.left, from}, {right, from}, {right, high}, {place.left, high}}, shown[i]});
  }
  for (double level : levels)
    if (level > range[0] && level < range[1])
      drawing.marks.push_back(Stroke{{{place.left, scale(level)}, {right, scale(level)}},
                                     tone_on(color_of(level, range, colors)),
                                     1.8 * style.unit});
  std::vector<Vec2> outline = {{place.left, high}, {place.left, low}};
  if (beyond[0]) {
    drawing.marks.push_back(Fill{{{place.left, low}, {middle, low - point}, {right, low}}, colors.front()});
    outline.push_back({middle, low - point});
  }
  outline.insert(outline.end(), {{right, low}, {right, high}});
  if (beyond[1]) {
    drawing.marks.push_back(Fill{{{place.left, high}, {right, high}, {middle, high + point}}, colors.back()});
    outline.push_back({middle, high + point});
  }
  outline.insert(outline.end(), {{place.left, high}, {place.left, low}});
  drawing.marks.push_back(Stroke{outline, bar_rim, 1.6 * style.unit});

  for (std::size_t i = 0; i < ticks.at.size() && !constant; ++i) {
    const double y = scale(ticks.at[i]);
    drawing.marks.push_back(Stroke{{{right, y}, {right + 0.22 * size, y}}, bar_rim, 1.6 * style.unit});
    drawing.marks.push_back(Text{{right + 0.45 * size, y - 0.36 * size}, ticks.labels[i], size, Align::left, ink});
  }
  if (!ticks.factor.empty() && !constant)
    drawing.marks.push_back(Text{{place.left, top - 0.8 * size}, ticks.factor, size, Align::left, ink});
  const double space = colorbar_room(range, title, top - bottom, style, log) - 1.3 * style.margin;
  // Zero up to rounding error is printed as zero.
  const double zero = 1e-12 * std::max(std::abs(values[0]), std::abs(values[1]));
  // Fewer digits where space is short: a number must not end in an ellipsis.
  const auto printed = [&](const std::string& name, double value) {
    std::string text;
    for (int digits = 3; digits > 0; --digits) {
      text = name + in_digits(std::abs(value) > zero ? value : 0, digits);
      if (!fit_text(text, 0.85 * size, std::min(0.85 * size, least_size(style)), space).cut) break;
    }
    return text;
  };
  for (const auto& [name, value, y] : {std::tuple{"max ", values[1], place.top - 0.8 * size},
                                       std::tuple{"min ", values[0], place.bottom + 0.1 * size}})
    draw_fitting(drawing, Text{{place.left, y}, printed(name, value), 0.85 * size, Align::left, ink}, space, style);
  if (!title.empty()) {
    const double x = right + 0.5 * size + widest_tick(ticks, size) + 1.15 * style.label_size;
    const FittedText fitted =
        fit_text(title, style.label_size, std::min(style.label_size, least_size(style)), top - bottom);
    const double half = 0.5 * fitted.width(), lowest = bottom + half;
    const double center = std::clamp(0.5 * (low + high), lowest, std::max(lowest, top - half));
    drawing.marks.push_back(Text{{x, center}, fitted.lines.front(), fitted.size, Align::center, ink, true});
  }
}

} // namespace signorini::view
