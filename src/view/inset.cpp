#include "view/curves.hpp"

#include "base/error.hpp"

namespace signorini::view {
namespace {

constexpr Rgb marked_color = {70, 70, 70}, edge_color = {200, 200, 200};

/// Width and height relative to the chart's, the largest first.
constexpr Vec2 sizes[] = {{0.5, 0.5}, {0.45, 0.5}, {0.5, 0.4},  {0.45, 0.45}, {0.4, 0.5},  {0.45, 0.4}, {0.4, 0.4},
                          {0.5, 0.3}, {0.35, 0.4}, {0.45, 0.3}, {0.4, 0.3},   {0.3, 0.35}, {0.35, 0.3}, {0.3, 0.3}};

/// The magnified range of y: as given, or that of the curves with a margin.
Range inset_yrange(const std::vector<Series>& series, const ChartOptions& options) {
  const Inset& inset = *options.inset;
  const auto [from, to] = inset.xrange;
  const Range own = range_within(series, inset.xrange, options.log_x, options.log_y);
  require(!own.empty(), "view.inset.no_curve", {{"low", from}, {"high", to}});
  return axis_range(own, inset.yrange, options.log_y, "the inset's y", 0.08);
}

/// Outline of the region in the chart, slightly enlarged, so that it does not coincide with the enclosed curves.
Box marked_box(const Frame& region, const Frame& chart, const Style& style) {
  const Box box =
      clipped(enlarged({chart.x(region.x.low), chart.x(region.x.high), chart.y(region.y.low), chart.y(region.y.high)},
                       6 * style.unit),
              chart.box);
  require(box[0] < box[1] && box[2] < box[3], "view.inset.outside_chart");
  return box;
}

/// Places the frame's box in the outer one, with space for its numbers.
void fit_frame(Frame& frame, const Box& outer, const std::vector<Name>& names, const Style& style) {
  const double size = style.tick_size, pad = 0.4 * size;
  frame.yticks = stacked_ticks(frame.y.low, frame.y.high, frame.y.log, outer[3] - outer[2] - 3 * size, style);
  frame.box[0] = outer[0] + pad + room_left(style, frame.yticks, "");
  frame.box[3] = outer[3] - pad - (frame.yticks.factor.empty() ? 0.4 : 1.3) * size;
  // Half of the last number extends beyond the end of the axis.
  double overhang = size;
  for (int round = 0; round < 2; ++round) {
    frame.box[1] = outer[1] - pad - overhang;
    frame.x.from = frame.box[0], frame.x.to = frame.box[1];
    frame.xticks = names.empty()
                       ? fitting_ticks(frame.x.low, frame.x.high, frame.x.log, frame.box[1] - frame.box[0], style)
                       : named_ticks(names, frame.x, 0, style);
    overhang = reach_of_ticks(frame, style)[1] - frame.box[1];
  }
  frame.box[2] = outer[2] + pad + (frame.xticks.factor.empty() ? 1.3 : 2.6) * size + frame.xticks.depth;
  frame.y.from = frame.box[2], frame.y.to = frame.box[3];
}

} // namespace

Box corner_box(Corner corner, const Vec2& size, const Box& box, double gap) {
  const bool east = corner == Corner::north_east || corner == Corner::south_east;
  const bool north = corner == Corner::north_east || corner == Corner::north_west;
  const double left = east ? box[1] - gap - size[0] : box[0] + gap;
  const double bottom = north ? box[3] - gap - size[1] : box[2] + gap;
  return {left, left + size[0], bottom, bottom + size[1]};
}

PlacedInset place_inset(const std::vector<Series>& series, const ChartOptions& options, const Frame& chart,
                        const Style& style, const std::optional<Box>& legend) {
  const Range xs = axis_range({}, options.inset->xrange, options.log_x, "the inset's x", 0);
  const Range ys = inset_yrange(series, options);
  PlacedInset inset;
  inset.style = style;
  inset.style.tick_size *= 0.8;
  inset.frame.x = {xs.low, xs.high, options.log_x, 0, 0};
  inset.frame.y = {ys.low, ys.high, options.log_y, 0, 0};
  inset.marked = marked_box(inset.frame, chart, style);

  Lines lines = lines_of(series, chart, style);
  for (const Box& box : {inset.marked, legend.value_or(inset.marked)}) {
    const auto& [left, right, bottom, top] = box;
    lines.insert(lines.end(), {outline_of(box), {{left, bottom}, {right, top}}, {{left, top}, {right, bottom}}});
  }
  inset.hidden = std::numeric_limits<double>::infinity();
  const double gap = 0.8 * style.tick_size, margin = 5 * style.unit, width = chart.box[1] - chart.box[0],
               height = chart.box[3] - chart.box[2];
  for (const Vec2& part : sizes) {
    const bool last = &part == &sizes[std::size(sizes) - 1];
    for (Corner corner : corners) {
      if (corner != options.inset->place.value_or(corner)) continue;
      const Box box = corner_box(corner, {part[0] * width, part[1] * height}, chart.box, gap);
      const double hidden = covered(lines, enlarged(box, margin));
      if (hidden < inset.hidden && (hidden == 0 || last)) inset.hidden = hidden, inset.outer = box;
    }
    if (inset.hidden == 0) break;
  }
  fit_frame(inset.frame, inset.outer, options.xticks, inset.style);
  return inset;
}

void draw_inset(Drawing& drawing, const std::vector<Series>& series, const ChartOptions& options,
                const PlacedInset& inset) {
  drawing.marks.push_back(Stroke{outline_of(inset.marked), marked_color, 1.8 * inset.style.unit});
  fill_box(drawing, inset.outer, white);
  drawing.marks.push_back(Stroke{outline_of(inset.outer), edge_color, 1.4 * inset.style.unit});
  draw_grid(drawing, inset.frame, inset.style);
  draw_rules(drawing, options, inset.frame, inset.style);
  draw_series(drawing, series, inset.frame, inset.style);
  draw_frame(drawing, inset.frame, inset.style);
}

} // namespace signorini::view
