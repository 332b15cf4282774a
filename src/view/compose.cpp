#include "view/compose.hpp"

#include "base/error.hpp"
#include "view/frame.hpp"
#include "view/sheet.hpp"
#include "view/text.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace signorini::view {
namespace {

int rows_of(int count, int columns) {
  return (count + columns - 1) / columns;
}

/// Maximum size of each picture; empty if that is too small.
std::optional<std::array<int, 2>> cell_of(int count, int columns, const std::array<int, 2>& paper) {
  const std::array<int, 2> cell = {paper[0] / columns, paper[1] / rows_of(count, columns)};
  if (cell[0] < 160 || cell[1] < 120) return std::nullopt;
  return cell;
}

/// A layout by number of columns, with the size of the first picture.
struct Trial {
  int columns = 0;
  std::array<int, 2> cell{};
  double area = 0;  ///< of the picture, pixels
  double shape = 0; ///< width/height of the figure
};

/// The columns for which the first picture is largest and the figure not higher than wide; otherwise the widest one.
Trial best_trial(int count, const PictureOptions& options, const std::array<int, 2>& paper, const FigureMaker& make) {
  std::vector<Trial> trials;
  Message reason("view.pictures.larger");
  const int most = std::min(options.columns.value_or(count), count);
  for (int columns = options.columns ? most : 1; columns <= most; ++columns) {
    const auto cell = cell_of(count, columns, paper);
    const bool ragged = !options.columns && columns > 1 && rows_of(count, columns) == rows_of(count, columns - 1);
    if (!cell || ragged) continue;
    try {
      const std::array<int, 2> size = make(0, *cell).size;
      const double width = size[0], height = size[1];
      trials.push_back({columns, *cell, width * height, columns * width / (rows_of(count, columns) * height)});
    } catch (const Error& error) {
      reason = error.message();
    }
  }
  require(!trials.empty(), "view.pictures.space",
          {{"count", count}, {"width", options.size[0]}, {"height", options.size[1]}, {"reason", reason}});
  constexpr double tower = 1; // width/height below which a figure counts as too high
  return *std::max_element(trials.begin(), trials.end(), [&](const Trial& a, const Trial& b) {
    const double first = std::min(a.shape, tower), second = std::min(b.shape, tower);
    return first != second ? first < second : a.area < b.area;
  });
}

/// Start positions of rows or columns of these widths.
std::vector<int> begins(const std::vector<int>& widths, int start) {
  std::vector<int> at(widths.size());
  std::exclusive_scan(widths.begin(), widths.end(), at.begin(), start);
  return at;
}

constexpr Rgb frame_color = {20, 20, 20};
constexpr int least_width = 160, least_height = 120; // minimum size of a picture, pixels

/// Number of sample points of bodies in a box.
long hidden_in(const Plate& plate, const Box& box) {
  long count = 0;
  for (const Relief& relief : plate.reliefs)
    for (const Field& field : relief.fields)
      for (const auto& p : field.points.colwise()) count += holds(box, {p[0], p[1]});
  return count;
}

/// The region of a frame that another frame shows magnified.
Box place_of(const Frame& detail, const Frame& whole) {
  return {whole.x(detail.x.low), whole.x(detail.x.high), whole.y(detail.y.low), whole.y(detail.y.high)};
}

Box extent_of(const Frame& frame) {
  return {frame.x.low, frame.x.high, frame.y.low, frame.y.high};
}

struct Placing {
  PlacedPlate inset;
  Box marked;
};

constexpr double shares[] = {0.5, 0.42, 0.35, 0.28};

/// Maximum size of a magnified part with this share of a frame; empty if that is too small.
std::optional<std::array<int, 2>> room_of(const Frame& frame, double share) {
  const auto& [left, right, bottom, top] = frame.box;
  const std::array<int, 2> most = {static_cast<int>(0.9 * std::sqrt(share) * (right - left)),
                                   static_cast<int>(share * (top - bottom))};
  if (most[0] < least_width || most[1] < least_height) return std::nullopt;
  return most;
}

/// Places a detail in corner 0 to 3 of a frame: north-east, south-east, north-west, south-west.
Placing placed(const Frame& frame, int corner, Plate detail) {
  const auto& [left, right, bottom, top] = frame.box;
  const double width = detail.drawing.size[0], height = detail.drawing.size[1], margin = 0.012 * (right - left);
  const double x = corner < 2 ? right - margin - width : left + margin,
               y = corner % 2 == 0 ? top - margin - height : bottom + margin;
  const Box marked = clipped(place_of(detail.frames.front(), frame), frame.box);
  return {{{static_cast<int>(std::round(x)), static_cast<int>(std::round(y))}, std::move(detail)}, marked};
}

Box box_of(const PlacedPlate& plate) {
  const double x = plate.at[0], y = plate.at[1];
  return {x, x + plate.plate.drawing.size[0], y, y + plate.plate.drawing.size[1]};
}

/// Costs of magnified parts of one share in one corner, summed over states.
struct Cost {
  long hidden = 0;     ///< covered points of bodies, and a large penalty for covering the marked region
  double distance = 0; ///< from the marked region, in diagonals of the frame: long joining lines cross bodies
};

/// By share and corner; fewer shares if frames are too small.
using Costs = std::vector<std::array<Cost, 4>>;

Vec2 middle(const Box& box) {
  return {0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3])};
}

void add_costs(Costs& costs, int picture, const Plate& whole, const DetailMaker& detail) {
  for (std::size_t state = 0; state < whole.frames.size(); ++state)
    for (std::size_t s = 0; s < costs.size(); ++s) {
      const Frame& frame = whole.frames[state];
      const auto most = room_of(frame, shares[s]);
      if (!most) {
        costs.resize(s);
        break;
      }
      const Plate plate = detail(picture, static_cast<int>(state), *most);
      require(overlap(frame.box, place_of(plate.frames.front(), frame)), "view.inset.outside_picture");
      const double diagonal = distance({frame.box[0], frame.box[2]}, {frame.box[1], frame.box[3]});
      for (int corner = 0; corner < 4; ++corner) {
        const Placing placing = placed(frame, corner, plate);
        const Box box = box_of(placing.inset);
        Cost& cost = costs[s][static_cast<std::size_t>(corner)];
        cost.hidden += hidden_in(whole, box) + (overlap(box, placing.marked) ? 1000000 : 0);
        cost.distance += distance(middle(box), middle(placing.marked)) / diagonal;
      }
    }
}

/// The plan that covers least; at equal coverage, large parts near the marked region. Empty if frames are too small.
std::optional<CloseUpPlan> best_plan(const Costs& costs, std::size_t states) {
  std::optional<CloseUpPlan> best;
  double merit = 0;
  for (std::size_t s = 0; s < costs.size(); ++s)
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const auto& [hidden, distance] = costs[s][corner];
      const double own = shares[s] - 0.35 * distance / static_cast<double>(states);
      if (best && (hidden > best->hidden || (hidden == best->hidden && own <= merit + 1e-9))) continue;
      best = {shares[s], static_cast<int>(corner), hidden};
      merit = own;
    }
  return best;
}

/// The two pairs of corners joined by lines, from the marked region to the inset.
std::array<std::array<Vec2, 2>, 2> joins(const Box& from, const Box& to) {
  const auto corner = [](const Box& box, int x, int y) { return Vec2{box[x], box[2 + y]}; };
  if (to[2] >= from[3]) return {{{corner(from, 0, 1), corner(to, 0, 0)}, {corner(from, 1, 1), corner(to, 1, 0)}}};
  if (to[3] <= from[2]) return {{{corner(from, 0, 0), corner(to, 0, 1)}, {corner(from, 1, 0), corner(to, 1, 1)}}};
  const int near = to[0] >= from[1] ? 0 : 1, side = 1 - near;
  return {{{corner(from, side, 0), corner(to, near, 0)}, {corner(from, side, 1), corner(to, near, 1)}}};
}

void draw_joins(Drawing& drawing, const Placing& placing) {
  const double width = std::max(1.0, 1.5e-3 * drawing.size[0]);
  const Box inset = enlarged(box_of(placing.inset), width);
  for (const Box& box : {placing.marked, inset})
    drawing.marks.push_back(Stroke{outline_of(box), frame_color, 1.4 * width});
  for (const auto& [from, to] : joins(placing.marked, inset))
    drawing.marks.push_back(Stroke{{from, to}, frame_color, width, {6 * width, 4 * width}});
}

} // namespace

Figure side_by_side(int count, const PictureOptions& options, const FigureMaker& make) {
  const Style style = style_of(options);
  const int head = options.title.empty() ? 0 : static_cast<int>(std::ceil(style.margin + 1.3 * style.title_size));
  const Trial best = best_trial(count, options, {options.size[0], options.size[1] - head}, make);
  const int columns = best.columns;
  std::vector<Figure> parts;
  std::vector<int> widths(columns), heights(rows_of(count, columns));
  for (int i = 0; i < count; ++i) {
    parts.push_back(make(i, best.cell));
    const std::array<int, 2>& size = parts.back().size;
    widths[i % columns] = std::max(widths[i % columns], size[0]);
    heights[i / columns] = std::max(heights[i / columns], size[1]);
  }

  const int wide = std::reduce(widths.begin(), widths.end()), high = std::reduce(heights.begin(), heights.end());
  std::array<int, 2> whole = options.size;
  const double title = text_width(options.title, style.title_size) + 2 * style.margin;
  if (options.trim)
    whole = {std::clamp(static_cast<int>(std::ceil(title)), wide, std::max(wide, whole[0])), high + head};
  const std::vector<int> left = begins(widths, (whole[0] - wide) / 2),
                         down = begins(heights, (whole[1] - high - head) / 2 + head);
  Figure figure{whole, {}};
  for (int i = 0; i < count; ++i) {
    const int column = i % columns, row = i / columns;
    const std::array<int, 2>& size = parts[static_cast<std::size_t>(i)].size;
    const int x = left[column] + (widths[column] - size[0]) / 2,
              y = whole[1] - down[row] - (heights[row] + size[1]) / 2;
    for (auto& [at, plate] : parts[static_cast<std::size_t>(i)].plates)
      figure.plates.push_back({{x + at[0], y + at[1]}, std::move(plate)});
  }
  if (!options.title.empty()) {
    // A plate only as high as the title, so that it covers no other plate.
    Drawing top{{whole[0], head}, {}};
    draw_title(top, options.title, {0.0, static_cast<double>(whole[0]), 0.0, 0.0}, style);
    figure.plates.push_back({{0, whole[1] - head}, {std::move(top)}});
  }
  return figure;
}

Style part_style(const std::array<int, 2>& size, const Style& whole) {
  const Style own = style_for(size);
  const double larger = std::sqrt(std::max(1.0, whole.unit / own.unit));
  return {own.unit * larger, own.tick_size * larger, own.label_size * larger, own.title_size * larger,
          own.margin * larger};
}

CloseUpPlan plan_close_ups(int pictures, const WholeMaker& make, const DetailMaker& detail) {
  std::optional<Box> extent;
  for (const bool raised : {false, true}) {
    Costs costs(std::size(shares));
    Box shown{};
    std::size_t states = 0;
    for (int picture = 0; picture < pictures; ++picture) {
      const Plate whole = make(picture, extent);
      add_costs(costs, picture, whole, detail);
      if (picture == 0) shown = extent_of(whole.frames.front());
      for (const Frame& frame : whole.frames) shown = hull({shown, extent_of(frame)});
      states += whole.frames.size();
    }
    auto best = best_plan(costs, states);
    if (best && (best->hidden == 0 || raised)) {
      best->extent = extent;
      return *best;
    }
    require(!raised, static_cast<int>(states) > pictures ? "view.inset.room_each" : "view.inset.room_or_crop");
    // Additional space above: 0.75 of the present height.
    extent = shown;
    (*extent)[3] += 0.75 * (shown[3] - shown[2]);
  }
  return {};
}

Figure with_close_ups(int picture, const CloseUpPlan& plan, const WholeMaker& make, const DetailMaker& detail) {
  Plate whole = make(picture, plan.extent);
  std::vector<PlacedPlate> insets;
  const std::vector<Frame> frames = whole.frames;
  for (std::size_t state = 0; state < frames.size(); ++state) {
    const auto most = room_of(frames[state], plan.share);
    require(most.has_value(), "view.inset.space");
    Placing placing = placed(frames[state], plan.corner, detail(picture, static_cast<int>(state), *most));
    draw_joins(whole.drawing, placing);
    insets.push_back(std::move(placing.inset));
  }
  Figure figure = figure_of(std::move(whole));
  for (PlacedPlate& inset : insets) figure.plates.push_back(std::move(inset));
  return figure;
}

Style close_up_style(Style whole) {
  whole.tick_size *= 0.8;
  whole.margin *= 0.35;
  return whole;
}

} // namespace signorini::view
