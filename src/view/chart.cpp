#include "view/chart.hpp"

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/warning.hpp"
#include "view/curves.hpp"
#include "view/legend.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::view {
namespace {

Message name_of(const std::vector<Series>& series, std::size_t i) {
  if (series[i].label.empty()) return Message("view.chart.series", {{"number", i}});
  return Message("view.chart.named_series", {{"number", i}, {"label", series[i].label}});
}

void check_positive(double value, char axis, const Message& series) {
  require(value > 0, "view.chart.log", {{"series", series}, {"axis", std::string(1, axis)}, {"value", value}});
}

void check(const std::vector<Series>& series, const ChartOptions& options) {
  bool any = false;
  for (std::size_t n = 0; n < series.size(); ++n) {
    const Series& s = series[n];
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      if (!drawn(s, i)) continue;
      any = true;
      if (options.log_x) check_positive(s.x[i], 'x', name_of(series, n));
      if (options.log_y) check_positive(s.y[i], 'y', name_of(series, n));
    }
  }
  require(options.marks.size() <= marker_names().size(), "view.chart.kinds",
          {{"count", options.marks.size()}, {"most", marker_names().size()}});
  require(any, "view.chart.no_point");
  const auto own = std::count_if(series.begin(), series.end(), [](const Series& s) { return s.line && !s.color; });
  if (own > distinct_curves()) warn("view.chart.many_curves", {{"count", own}, {"distinct", distinct_curves()}});
}

void check_names(const std::vector<Name>& names, const std::string& what, char axis, bool log) {
  for (const auto& [at, name] : names)
    require(!log || at > 0, "view.chart.place_log",
            {{"what", what}, {"name", name}, {"axis", std::string(1, axis)}, {"at", at}});
}

void check_names(const ChartOptions& options) {
  check_names(options.xticks, "tick", 'x', options.log_x);
  check_names(options.vlines, "line", 'x', options.log_x);
  check_names(options.hlines, "line", 'y', options.log_y);
  for (std::size_t i = 1; i < options.xticks.size(); ++i)
    require(options.xticks[i - 1].at < options.xticks[i].at, "view.chart.ticks",
            {{"name", options.xticks[i].text},
             {"at", options.xticks[i].at},
             {"before", options.xticks[i - 1].text},
             {"at_before", options.xticks[i - 1].at}});
}

/// The range of all drawn x, including named ticks with a margin in proportion to their distance.
Range chart_xrange(const std::vector<Series>& series, const ChartOptions& options) {
  Range xs;
  for (const Series& s : series)
    for (std::size_t i = 0; i < s.x.size(); ++i)
      if (drawn(s, i)) xs.take(s.x[i]);
  for (const Name& rule : options.vlines) xs.take(rule.at);
  const auto& names = options.xticks;
  double margin = 0.02;
  if (names.size() >= 2) {
    xs.take(names.front().at), xs.take(names.back().at);
    margin = 0.3 / (names.size() - 1);
  }
  return axis_range(xs, options.xrange, options.log_x, "x", margin);
}

Range chart_yrange(const std::vector<Series>& series, const ChartOptions& options, const Range& xs) {
  Range ys = range_within(series, {xs.low, xs.high}, options.log_x, options.log_y);
  require(!ys.empty() || options.yrange, "view.chart.no_curve", {{"low", xs.low}, {"high", xs.high}});
  for (const Name& rule : options.hlines) ys.take(rule.at);
  return axis_range(ys, options.yrange, options.log_y, "y", 0.05);
}

struct ChartLayout {
  Frame frame;
  Legend legend;
  double title_at; ///< pixels: below the title, above everything else
};

/// Narrows the box until the labels below it end within the figure.
void fit_ticks(Frame& frame, const Range& xs, const ChartOptions& options, const Style& style) {
  const double rim = 0.5 * style.margin, most = 0.35 * options.size[1];
  for (int round = 0; round < 3; ++round) {
    auto& [left, right, bottom, top] = frame.box;
    frame.x = {xs.low, xs.high, options.log_x, left, right};
    frame.xticks = options.xticks.empty() ? fitting_ticks(xs.low, xs.high, options.log_x, right - left, style)
                                          : named_ticks(options.xticks, frame.x, most, style);
    const auto [from, to] = reach_of_ticks(frame, style);
    if (from >= rim && to <= options.size[0] - rim) return;
    left += std::max(0.0, rim - from);
    right -= std::max(0.0, to - options.size[0] + rim);
  }
}

/// Layout with the legend outside, or without. `depth`: pixels that names of ticks need below the row of numbers, as
/// far as known.
ChartLayout lay_out(const std::vector<Series>& series, const ChartOptions& options, const Range& xs, const Range& ys,
                    const Style& style, double depth = 0) {
  ChartLayout layout;
  Frame& frame = layout.frame;
  frame.xlabel = options.xlabel;
  frame.ylabel = options.ylabel;
  double bottom = style.margin + room_below(style, options.xlabel) + depth;
  double height = options.size[1] - bottom - style.margin - title_room(options.title, options.size[0], style);
  frame.yticks = stacked_ticks(ys.low, ys.high, options.log_y, height, style);
  const double raised = frame.yticks.factor.empty() ? 0 : 1.2 * style.tick_size;
  layout.legend = make_legend(series, options, style, height - raised);
  bottom += layout.legend.height;
  height -= layout.legend.height;
  if (layout.legend.height > 0) frame.yticks = stacked_ticks(ys.low, ys.high, options.log_y, height, style);
  const double left = style.margin + room_left(style, frame.yticks, options.ylabel);
  const double right = options.size[0] - style.margin - std::max(layout.legend.width, style.margin);
  const double top = bottom + height - raised;
  frame.box = {left, right, bottom, top};
  fit_ticks(frame, xs, options, style);
  require(frame.box[1] - frame.box[0] >= 0.2 * options.size[0] && top - bottom >= 0.2 * options.size[1],
          "view.chart.space", {{"width", options.size[0]}, {"height", options.size[1]}});
  if (frame.xticks.depth > depth + 1) return lay_out(series, options, xs, ys, style, frame.xticks.depth);
  frame.y = {ys.low, ys.high, options.log_y, bottom, top};
  layout.title_at = top + raised;
  return layout;
}

/// Layout with the legend within the chart, if the options and the curves allow that.
std::optional<ChartLayout> lay_out_within(const std::vector<Series>& series, const ChartOptions& options,
                                          const Range& xs, const Range& ys, const Style& style) {
  const bool always = options.legend == LegendPlace::inside;
  if (!always && (options.legend != LegendPlace::automatic || options.inset)) return std::nullopt;
  ChartOptions bare = options;
  bare.legend = LegendPlace::none;
  ChartLayout layout = lay_out(series, bare, xs, ys, style);
  const Box& box = layout.frame.box;
  Lines lines = lines_of(series, layout.frame, style);
  for (const Name& rule : options.hlines)
    lines.push_back({{box[0], layout.frame.y(rule.at)}, {box[1], layout.frame.y(rule.at)}});
  for (const Name& rule : options.vlines)
    lines.push_back({{layout.frame.x(rule.at), box[2]}, {layout.frame.x(rule.at), box[3]}});
  const auto legend = legend_within(series, options, box, lines, always, style);
  if (!legend) return std::nullopt;
  layout.legend = *legend;
  return layout;
}

/// The range, extended at one end to make space for an inset.
Range with_room(const Range& ys, bool log, bool below) {
  constexpr double space = 0.6; // of the present height: the smallest inset takes 0.3 of the extended height
  const double grown = log ? std::pow(ys.high / ys.low, space) : space * (ys.high - ys.low);
  if (below) return {log ? ys.low / grown : ys.low - grown, ys.high};
  return {ys.low, log ? ys.high * grown : ys.high + grown};
}

/// The layout of everything in a chart.
struct ChartPlan {
  ChartLayout layout;
  std::optional<PlacedInset> inset;
};

ChartPlan plan(const std::vector<Series>& series, const ChartOptions& options, const Style& style) {
  const Range xs = chart_xrange(series, options), ys = chart_yrange(series, options, xs);
  const auto within = lay_out_within(series, options, xs, ys, style);
  ChartLayout layout = within ? *within : lay_out(series, options, xs, ys, style);
  std::optional<PlacedInset> inset;
  if (options.inset) {
    inset = place_inset(series, options, layout.frame, style, layout.legend.within);
    if (inset->hidden > 0 && !options.yrange) {
      const auto place = options.inset->place;
      const bool below = place == Corner::south_east || place == Corner::south_west;
      layout = lay_out(series, options, xs, with_room(ys, options.log_y, below), style);
      inset = place_inset(series, options, layout.frame, style, layout.legend.within);
    }
  }
  return {std::move(layout), std::move(inset)};
}

Drawing draw(const std::vector<Series>& series, const ChartOptions& options) {
  const Style style = style_for(options.size);
  const auto [layout, inset] = plan(series, options, style);
  const Frame& frame = layout.frame;
  Drawing drawing{options.size, {}};
  draw_grid(drawing, frame, style);
  draw_rules(drawing, options, frame, style);
  draw_series(drawing, series, frame, style);
  std::vector<Box> taken;
  if (layout.legend.within) taken.push_back(*layout.legend.within);
  if (inset) {
    draw_inset(drawing, series, options, *inset);
    taken.push_back(inset->outer);
  }
  draw_rule_texts(drawing, options, frame, lines_of(series, frame, style), taken, style);
  draw_frame(drawing, frame, style);
  draw_legend(drawing, layout.legend, series, frame.box, style);
  draw_title(drawing, options.title, {frame.box[0], frame.box[1], frame.box[2], layout.title_at}, style);
  return drawing;
}

/// The position of a point along x: the name of the tick there, or the number.
std::string place_text(double x, const std::vector<Name>& ticks) {
  const auto tick = std::find_if(ticks.begin(), ticks.end(), [&](const Name& name) { return name.at == x; });
  return tick == ticks.end() ? text(x) : tick->text;
}

} // namespace

Figure chart_figure(const std::vector<Series>& series, const ChartOptions& options) {
  check(series, options);
  check_names(options);
  return figure_of({draw(series, options)});
}

std::vector<Spot> chart_spots(const std::vector<Series>& series, const ChartOptions& options) {
  check(series, options);
  check_names(options);
  const auto [layout, inset] = plan(series, options, style_for(options.size));
  std::vector<Spot> spots;
  for (const Series& s : series)
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      if (!drawn(s, i)) continue;
      const Vec2 at = {layout.frame.x(s.x[i]), layout.frame.y(s.y[i])};
      if (!holds(enlarged(layout.frame.box, 0.5), at) || (inset && holds(inset->outer, at))) continue;
      Spot& spot = spots.emplace_back(Spot{{at[0], at[0], at[1], at[1]}});
      spot.add(options.legend_title, s.label);
      spot.add(options.xlabel, place_text(s.x[i], options.xticks));
      spot.add(options.ylabel, text(s.y[i]));
      if (!s.marks.empty()) spot.add(options.marks_title, options.marks[static_cast<std::size_t>(s.marks[i])]);
    }
  return spots;
}

} // namespace signorini::view
