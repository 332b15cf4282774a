// Names in the place of numbers along an axis.

#include "view/frame.hpp"
#include "view/text.hpp"

#include <algorithm>
#include <cctype>

namespace signorini::view {
namespace {

/// Pixels that a name at tick i may take: its neighbours' take as much.
double room_for(const Ticks& ticks, std::size_t i, const Scale& scale) {
  double room = scale.to - scale.from;
  if (i > 0) room = std::min(room, scale(ticks.at[i]) - scale(ticks.at[i - 1]));
  if (i + 1 < ticks.at.size()) room = std::min(room, scale(ticks.at[i + 1]) - scale(ticks.at[i]));
  return room;
}

/// All on one line in one size; false where that would be too small.
bool shrink_names(Ticks& ticks, const Scale& scale, bool within_cells, const Style& style) {
  double size = style.tick_size;
  for (std::size_t i = 0; i < ticks.at.size() && within_cells; ++i)
    size = std::min(size, room_for(ticks, i, scale) / (text_width(ticks.labels[i], 1) + 0.6));
  for (std::size_t i = 1; i < ticks.at.size(); ++i) {
    const double needed = 0.5 * (text_width(ticks.labels[i - 1], 1) + text_width(ticks.labels[i], 1)) + 0.6;
    size = std::min(size, (scale(ticks.at[i]) - scale(ticks.at[i - 1])) / needed);
  }
  for (const std::string& label : ticks.labels) ticks.names.push_back({{label}, size});
  return size >= least_size(style);
}

/// Each on up to three lines, in a size of its own; false where one is cut short.
bool wrap_names(Ticks& ticks, const Scale& scale, const Style& style) {
  bool whole = true;
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    const double room = room_for(ticks, i, scale) - 0.6 * least_size(style);
    ticks.names[i] = fit_text(ticks.labels[i], style.tick_size, least_size(style), room, 3);
    ticks.depth = std::max(ticks.depth, ticks.names[i].depth());
    whole = whole && !ticks.names[i].cut;
  }
  return whole;
}

/// Between the closest two names, pixels.
double closest(const Ticks& ticks, const Scale& scale) {
  double room = scale.to - scale.from;
  for (std::size_t i = 0; i < ticks.at.size(); ++i) room = std::min(room, room_for(ticks, i, scale));
  return room;
}

/// Without those that stand closer than `apart` pixels to the one before.
Ticks thinned(const Ticks& ticks, const Scale& scale, double apart) {
  Ticks kept;
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    if (!kept.at.empty() && scale(ticks.at[i]) - scale(kept.at.back()) < apart - 1e-9) continue;
    kept.at.push_back(ticks.at[i]), kept.labels.push_back(ticks.labels[i]);
  }
  return kept;
}

/// Of numbers some can be left out: readers know those between.
bool is_number(const std::string& name) {
  return std::none_of(name.begin(), name.end(), [](unsigned char c) { return std::isalpha(c) != 0; });
}

Ticks thin_out_numbers(const Ticks& ticks, const Scale& scale, const Style& style) {
  const double size = least_size(style);
  double width = 0;
  for (const std::string& label : ticks.labels) width = std::max(width, text_width(label, size));
  Ticks kept = thinned(ticks, scale, width + 0.6 * size);
  for (const std::string& label : kept.labels) kept.names.push_back({{label}, size});
  return kept;
}

/// Names across the axis, on as many lines as there is room for.
Ticks lines_across(const Ticks& ticks, const Scale& scale, double most, double step, const Style& style) {
  const double room = closest(ticks, scale), size = std::clamp(room / step, least_size(style), style.tick_size);
  Ticks kept = thinned(ticks, scale, step * size);
  const int lines = std::clamp(static_cast<int>(room / (line_step * size) - 0.3), 1, 3);
  for (const std::string& label : kept.labels)
    kept.names.push_back(fit_text(label, size, least_size(style), most, lines));
  return kept;
}

Ticks within(const std::vector<Name>& names, const Scale& scale) {
  Ticks ticks;
  for (const auto& [at, name] : names)
    if (at >= scale.low && at <= scale.high) ticks.at.push_back(at), ticks.labels.push_back(name);
  return ticks;
}

} // namespace

Ticks named_ticks(const std::vector<Name>& names, const Scale& scale, double most, const Style& style,
                  bool within_cells) {
  Ticks ticks = within(names, scale);
  if (shrink_names(ticks, scale, within_cells, style)) return ticks;
  if (std::all_of(ticks.labels.begin(), ticks.labels.end(), is_number)) return thin_out_numbers(ticks, scale, style);
  if (wrap_names(ticks, scale, style) || most < 2 * style.tick_size) return ticks;
  Ticks upright = lines_across(ticks, scale, most, line_step, style);
  upright.upright = true;
  for (const FittedText& name : upright.names) upright.depth = std::max(upright.depth, name.width() - style.tick_size);
  return upright;
}

Ticks stacked_names(const std::vector<Name>& names, const Scale& scale, double most, const Style& style) {
  constexpr double step = 1.15; // from one name to the next at the least, in its size
  return lines_across(within(names, scale), scale, most, step, style);
}

} // namespace signorini::view
