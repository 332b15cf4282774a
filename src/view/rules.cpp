#include "view/rules.hpp"

#include "view/fit_text.hpp"
#include "view/text.hpp"

#include <algorithm>

namespace signorini::view {
namespace {

constexpr Rgb rule_colour = {110, 110, 110};

bool crosses(const Scale& scale, double value) {
  return value >= scale.low && value <= scale.high;
}

bool overlap(const Box& a, const Box& b) {
  return a[0] < b[1] && b[0] < a[1] && a[2] < b[3] && b[2] < a[3];
}

/// Places for a text of the given extents along and across a line at pixel `at`: at its far end, its near end and
/// between, on either side. As a box {from, to} along the line and {from, to} across it.
std::vector<Box> places(double at, double from, double to, double along, double across, double gap) {
  std::vector<Box> result;
  const double first = from + gap, last = to - gap - along;
  for (double part : {1.0, 0.0, 0.5, 0.75, 0.25, 0.875, 0.625, 0.375, 0.125})
    for (double base : {at + 0.6 * gap, at - 0.6 * gap - across}) {
      const double start = first + part * (last - first);
      result.push_back({start, start + along, base, base + across});
    }
  return result;
}

/// The other reference lines: those that the text would lie on, and those as near to it as its own.
double hidden_by_rules(const Box& place, bool vertical, const Name& own, const ChartOptions& options,
                       const Frame& frame, double gap) {
  const auto lies_on = [](double at, double from, double to) { return at > from && at < to ? 1.0 : 0.0; };
  double hidden = 0;
  for (const Name& rule : options.vlines) {
    if (vertical && rule.at == own.at) continue;
    const double air = vertical ? gap : 0.2 * gap;
    hidden += lies_on(frame.x(rule.at), place[0] - air, place[1] + air);
  }
  for (const Name& rule : options.hlines) {
    if (!vertical && rule.at == own.at) continue;
    const double air = vertical ? 0.2 * gap : gap;
    hidden += lies_on(frame.y(rule.at), place[2] - air, place[3] + air);
  }
  return hidden;
}

void draw_text(Drawing& drawing, const Name& rule, bool vertical, const ChartOptions& options, const Frame& frame,
               const Lines& curves, std::vector<Box>& taken, const Style& style) {
  const Scale& scale = vertical ? frame.x : frame.y;
  if (rule.text.empty() || !crosses(scale, rule.at)) return;
  const auto& [left, right, bottom, top] = frame.box;
  const double full = 0.85 * style.tick_size, gap = 0.5 * full;
  const double at = scale(rule.at);
  const bool upright = vertical && text_width(rule.text, full) > 3 * full; // a sign or two reads better level
  const FittedText fitted =
      fit_text(rule.text, full, std::min(full, least_size(style)), (upright ? top - bottom : right - left) - 2 * gap);
  const double size = fitted.size, length = fitted.width();
  const std::vector<Box> candidates = upright    ? places(at, bottom, top, length, size, gap)
                                      : vertical ? places(at, bottom, top, size, length, gap)
                                                 : places(at, left, right, length, size, gap);
  double least = std::numeric_limits<double>::infinity();
  Box best = frame.box;
  for (Box place : candidates) {
    if (vertical) place = {place[2], place[3], place[0], place[1]};
    double hidden = covered(curves, place) + 1e3 * size * hidden_by_rules(place, vertical, rule, options, frame, gap);
    for (const Box& box : taken)
      if (overlap(place, box)) hidden += 1e6;
    if (place[0] < left || place[1] > right || place[2] < bottom || place[3] > top) hidden += 1e6;
    if (hidden < least) least = hidden, best = place;
  }
  taken.push_back(best);
  // A fifth of the height lies below the baseline.
  const Vec2 start = upright ? Vec2{best[1] - 0.2 * size, best[2]} : Vec2{best[0], best[2] + 0.2 * size};
  drawing.marks.push_back(Text{start, fitted.lines.front(), size, Align::left, ink, upright});
}

} // namespace

void draw_rules(Drawing& drawing, const ChartOptions& options, const Frame& frame, const Style& style) {
  const auto& [left, right, bottom, top] = frame.box;
  const auto rule = [&](const Vec2& from, const Vec2& to) {
    drawing.marks.push_back(Stroke{{from, to}, rule_colour, 2 * style.unit, {5 * style.unit, 6 * style.unit}});
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
