// Reference lines across a chart.

#include "view/curves.hpp"

#include "view/text.hpp"

#include <algorithm>

namespace signorini::view {
namespace {

constexpr Rgb rule_color = {110, 110, 110};

bool crosses(const Scale& scale, double value) {
  return value >= scale.low && value <= scale.high;
}

/// A position of a text next to a line: {from, to} along the line and {from, to} across it.
struct RulePlace {
  Box box;
  bool far; ///< needs a leader to its line
};

/// Candidate positions of a text with the given extents along and across a line at pixel `at`: at its far end, its near
/// end and between, on either side; then those further away.
std::vector<RulePlace> places(double at, double from, double to, double along, double across, double gap) {
  std::vector<RulePlace> result;
  const double first = from + gap, last = to - gap - along;
  for (int away = 0; away < 4; ++away)
    for (double part : {1.0, 0.0, 0.5, 0.75, 0.25, 0.875, 0.625, 0.375, 0.125})
      for (double side : {1.0, -1.0}) {
        const double start = first + part * (last - first), near = 0.6 * gap + away * (across + 0.6 * gap);
        const double base = side > 0 ? at + near : at - near - across;
        result.push_back({{start, start + along, base, base + across}, away > 0});
      }
  return result;
}

/// The number of other reference lines that the text would cover or to which it would be as near as to its own.
int hidden_by_rules(const Box& box, bool far, bool vertical, const Name& own, const ChartOptions& options,
                    const Frame& frame, double gap) {
  int hidden = 0;
  const auto count = [&](const std::vector<Name>& rules, const Scale& scale, double from, double to, bool along) {
    const double margin = along && !far ? gap : 0.2 * gap;
    for (const Name& rule : rules) {
      const double at = scale(rule.at);
      if (!(along && rule.at == own.at) && crosses(scale, rule.at) && at > from - margin && at < to + margin) ++hidden;
    }
  };
  count(options.vlines, frame.x, box[0], box[1], vertical);
  count(options.hlines, frame.y, box[2], box[3], !vertical);
  return hidden;
}

/// From the line to a text at a distance, ending in a dot on the line.
void draw_leader(Drawing& drawing, const RulePlace& place, double at, double gap, bool vertical, const Style& style) {
  const auto& [from, to, low, high] = place.box;
  const double start = from - 0.4 * gap, end = low > at ? low + gap : high - gap, dot = 4 * style.unit;
  const auto point = [&](double along, double across) { return vertical ? Vec2{across, along} : Vec2{along, across}; };
  drawing.marks.push_back(Stroke{{point(start, at), point(start, end)}, rule_color, 1.6 * style.unit});
  drawing.marks.push_back(Fill{
      {point(start - dot, at), point(start, at - dot), point(start + dot, at), point(start, at + dot)}, rule_color});
}

void draw_text(Drawing& drawing, const Name& rule, bool vertical, const ChartOptions& options, const Frame& frame,
               const Lines& curves, std::vector<Box>& taken, const Style& style) {
  const Scale& scale = vertical ? frame.x : frame.y;
  if (rule.text.empty() || !crosses(scale, rule.at)) return;
  const auto& [left, right, bottom, top] = frame.box;
  const double full = 0.85 * style.tick_size, gap = 0.5 * full;
  const double at = scale(rule.at);
  const bool upright = vertical && text_width(rule.text, full) > 3 * full; // short texts are drawn horizontally
  const FittedText fitted =
      fit_text(rule.text, full, std::min(full, least_size(style)), (upright ? top - bottom : right - left) - 2 * gap);
  const double size = fitted.size, length = fitted.width();
  const std::vector<RulePlace> candidates = upright    ? places(at, bottom, top, length, size, gap)
                                            : vertical ? places(at, bottom, top, size, length, gap)
                                                       : places(at, left, right, length, size, gap);
  const auto on_paper = [&](const Box& box) { return vertical ? Box{box[2], box[3], box[0], box[1]} : box; };
  double least = std::numeric_limits<double>::infinity();
  RulePlace best{};
  for (const RulePlace& place : candidates) {
    const Box box = on_paper(place.box);
    const double worst = 1e3 * size; // more than curves can be covered
    double hidden = covered(curves, box) + (place.far ? 0.5 * worst : 0) +
                    worst * hidden_by_rules(box, place.far, vertical, rule, options, frame, gap);
    for (const Box& other : taken)
      if (overlap(box, other)) hidden += 100 * worst;
    if (box[0] < left || box[1] > right || box[2] < bottom || box[3] > top) hidden += 100 * worst;
    if (hidden < least) least = hidden, best = place;
  }
  const Box box = on_paper(best.box);
  taken.push_back(box);
  if (best.far) draw_leader(drawing, best, at, gap, vertical, style);
  // A fifth of the height is below the baseline.
  const Vec2 start = upright ? Vec2{box[1] - 0.2 * size, box[2]} : Vec2{box[0], box[2] + 0.2 * size};
  drawing.marks.push_back(Text{start, fitted.lines.front(), size, Align::left, ink, upright});
}

} // namespace

void draw_rules(Drawing& drawing, const ChartOptions& options, const Frame& frame, const Style& style) {
  const auto& [left, right, bottom, top] = frame.box;
  const auto rule = [&](const Vec2& from, const Vec2& to) {
    drawing.marks.push_back(Stroke{{from, to}, rule_color, 2 * style.unit, {5 * style.unit, 6 * style.unit}});
  };
  for (const auto& [at, name] : options.hlines)
    if (crosses(frame.y, at)) rule({left, frame.y(at)}, {right, frame.y(at)});
  for (const auto& [at, name] : options.vlines)
    if (crosses(frame.x, at)) rule({frame.x(at), bottom}, {frame.x(at), top});
}

void draw_rule_texts(Drawing& drawing, const ChartOptions& options, const Frame& frame, const Lines& curves,
                     std::vector<Box> taken, const Style& style) {
  for (const Name& rule : options.hlines) draw_text(drawing, rule, false, options, frame, curves, taken, style);
  for (const Name& rule : options.vlines) draw_text(drawing, rule, true, options, frame, curves, taken, style);
}

} // namespace signorini::view
