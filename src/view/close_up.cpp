#include "view/close_up.hpp"

#include "base/error.hpp"
#include "base/index.hpp"
#include "view/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::view {
namespace {

constexpr Rgb frame_colour = {20, 20, 20};
constexpr int least_width = 160, least_height = 120; // pixels: that any picture has

bool is_within(double x, double y, const Box& box) {
  return x >= box[0] && x <= box[1] && y >= box[2] && y <= box[3];
}

bool overlap(const Box& a, const Box& b) {
  return a[0] < b[1] && b[0] < a[1] && a[2] < b[3] && b[2] < a[3];
}

/// How many of the points that the bodies are made of lie in a box.
long hidden(const Plate& plate, const Box& box) {
  long count = 0;
  for (const Field& field : plate.fields)
    for (const Vec2& p : field.points) count += is_within(p[0], p[1], box);
  for (const Shaded& surface : plate.relief.surfaces)
    for (const Vec3& p : surface.points) count += is_within(p[0], p[1], box);
  return count;
}

/// Where a frame shows what another one shows of the model.
Box place_of(const Frame& detail, const Frame& whole) {
  return {whole.x(detail.x.low), whole.x(detail.x.high), whole.y(detail.y.low), whole.y(detail.y.high)};
}

Box extent_of(const Frame& frame) {
  return {frame.x.low, frame.x.high, frame.y.low, frame.y.high};
}

struct Placing {
  long hidden = std::numeric_limits<long>::max();
  PlacedPlate inset{{}, {{{}, {}}}};
  Box marked{};
};

/// A magnified part of this share of its frame, in the corner where it hides least.
Placing place(const Plate& whole, int state, double share, const DetailMaker& detail) {
  const Frame& frame = whole.frames[static_cast<std::size_t>(state)];
  const auto& [left, right, bottom, top] = frame.box;
  const std::array<int, 2> most = {static_cast<int>(0.9 * std::sqrt(share) * (right - left)),
                                   static_cast<int>(share * (top - bottom))};
  Placing best;
  if (most[0] < least_width || most[1] < least_height) return best;
  Plate plate = detail(state, most);
  const double width = plate.drawing.size[0], height = plate.drawing.size[1];
  const double air = 0.012 * (right - left);
  const Box marked = place_of(plate.frames.front(), frame);
  for (const double x : {right - air - width, left + air})
    for (const double y : {top - air - height, bottom + air}) {
      const Box box = {x, x + width, y, y + height};
      const long count = hidden(whole, box) + (overlap(box, marked) ? 1000000 : 0);
      if (count < best.hidden)
        best = {count, {{static_cast<int>(std::round(x)), static_cast<int>(std::round(y))}, plate}, marked};
    }
  return best;
}

struct Placings {
  std::vector<Placing> of_states;
  bool found = true; ///< a place for each
  long hidden = 0;
};

/// The largest magnified parts that hide nothing, or those that hide least, of one share in all states.
Placings place(const Plate& whole, const DetailMaker& detail) {
  Placings best{{}, false, std::numeric_limits<long>::max()};
  for (const double share : {0.5, 0.42, 0.35, 0.28}) {
    Placings next;
    for (int state = 0; next.found && state < static_cast<int>(whole.frames.size()); ++state) {
      next.of_states.push_back(place(whole, state, share, detail));
      next.found = next.of_states.back().hidden < std::numeric_limits<long>::max();
      next.hidden += next.found ? next.of_states.back().hidden : 0;
    }
    if (next.found && next.hidden < best.hidden) best = std::move(next);
    if (best.hidden == 0) break;
  }
  return best;
}

/// The two pairs of corners that lines join, from the marked region to the inset.
std::array<std::array<Vec2, 2>, 2> joins(const Box& from, const Box& to) {
  const auto corner = [](const Box& box, int x, int y) { return Vec2{box[at(x)], box[at(2 + y)]}; };
  if (to[2] >= from[3]) return {{{corner(from, 0, 1), corner(to, 0, 0)}, {corner(from, 1, 1), corner(to, 1, 0)}}};
  if (to[3] <= from[2]) return {{{corner(from, 0, 0), corner(to, 0, 1)}, {corner(from, 1, 0), corner(to, 1, 1)}}};
  const int near = to[0] >= from[1] ? 0 : 1, side = 1 - near;
  return {{{corner(from, side, 0), corner(to, near, 0)}, {corner(from, side, 1), corner(to, near, 1)}}};
}

void draw_joins(Drawing& drawing, const Placing& placing) {
  const auto& [at, plate] = placing.inset;
  const double x = at[0], y = at[1], width = std::max(1.0, 1.5e-3 * drawing.size[0]);
  const Box inset = {x - width, x + plate.drawing.size[0] + width, y - width, y + plate.drawing.size[1] + width};
  for (const auto& [left, right, bottom, top] : {placing.marked, inset})
    drawing.marks.push_back(
        Stroke{{{left, bottom}, {right, bottom}, {right, top}, {left, top}, {left, bottom}, {right, bottom}},
               frame_colour,
               1.4 * width});
  for (const auto& [from, to] : joins(placing.marked, inset))
    drawing.marks.push_back(Stroke{{from, to}, frame_colour, width, {6 * width, 4 * width}});
}

} // namespace

Figure with_close_ups(const WholeMaker& make, const DetailMaker& detail) {
  Plate whole = make(std::nullopt);
  Placings placings = place(whole, detail);
  if (placings.hidden > 0) {
    // Room above: as much again as half of what is shown.
    Box shown = extent_of(whole.frames.front());
    for (const Frame& frame : whole.frames) shown = hull({shown, extent_of(frame)});
    shown[3] += 0.75 * (shown[3] - shown[2]);
    whole = make(shown);
    placings = place(whole, detail);
  }
  require(placings.found, "the picture is too small for an inset",
          whole.frames.size() > 1 ? " in each state; choose a larger size or fewer columns" : "; choose a larger size",
          ", or crop = … for a picture of its own");
  for (const Placing& placing : placings.of_states) draw_joins(whole.drawing, placing);
  Figure figure = figure_of(std::move(whole));
  for (Placing& placing : placings.of_states) figure.plates.push_back(std::move(placing.inset));
  return figure;
}

Style close_up_style(Style whole) {
  whole.tick_size *= 0.8;
  whole.margin *= 0.35;
  return whole;
}

} // namespace signorini::view
