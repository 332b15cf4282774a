// Names in the place of numbers along x.

#include "view/frame.hpp"
#include "view/text.hpp"

#include <algorithm>

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
bool shrink_names(Ticks& ticks, const Scale& scale, const Style& style) {
  double size = style.tick_size;
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

void stand_names_up(Ticks& ticks, const Scale& scale, double most, const Style& style) {
  double closest = style.tick_size * line_step;
  for (std::size_t i = 0; i < ticks.at.size(); ++i) closest = std::min(closest, room_for(ticks, i, scale));
  const double size = std::max(closest / line_step, least_size(style));
  Ticks kept;
  kept.upright = true;
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    if (!kept.at.empty() && scale(ticks.at[i]) - scale(kept.at.back()) < (line_step - 1e-9) * size) continue;
    kept.at.push_back(ticks.at[i]), kept.labels.push_back(ticks.labels[i]);
    kept.names.push_back(fit_text(ticks.labels[i], size, least_size(style), most));
    kept.depth = std::max(kept.depth, kept.names.back().width() - style.tick_size);
  }
  ticks = std::move(kept);
}

} // namespace

Ticks named_ticks(const std::vector<Name>& names, const Scale& scale, double most, const Style& style) {
  Ticks ticks;
  for (const auto& [at, name] : names)
    if (at >= scale.low && at <= scale.high) ticks.at.push_back(at), ticks.labels.push_back(name);
  if (shrink_names(ticks, scale, style) || wrap_names(ticks, scale, style)) return ticks;
  if (most >= 2 * style.tick_size) stand_names_up(ticks, scale, most, style);
  return ticks;
}

} // namespace signorini::view
