#include "view/marks.hpp"

#include "view/text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace signorini::view {
namespace {

using Polyline = std::vector<Vec2>;

constexpr Rgb ring_color = {200, 0, 60};

double radius(const Style& style) {
  return 11 * style.unit;
}
/// Half length of the lines of the cross.
double arm(const Style& style) {
  return 1.7 * radius(style);
}
/// Clamps a value to the interval; to its upper end if it is empty.
double pushed(double value, double low, double high) {
  return std::min(std::max(value, low), high);
}
Box box_about(const Vec2& at, double reach) {
  return {at[0] - reach, at[0] + reach, at[1] - reach, at[1] + reach};
}

/// White outline, visible on any color.
void draw_ring(Drawing& drawing, const Vec2& at, const Style& style) {
  const double reach = arm(style);
  const Polyline ring = circle_about(at, radius(style)), level = {{at[0] - reach, at[1]}, {at[0] + reach, at[1]}},
                 steep = {{at[0], at[1] - reach}, {at[0], at[1] + reach}};
  for (const Polyline& line : {ring, level, steep}) drawing.marks.push_back(Stroke{line, white, 8 * style.unit});
  drawing.marks.push_back(Stroke{ring, ring_color, 3.4 * style.unit});
  for (const Polyline& line : {level, steep}) drawing.marks.push_back(Stroke{line, ring_color, 2 * style.unit});
}

void draw_dot(Drawing& drawing, const Vec2& at, const Style& style) {
  drawing.marks.push_back(Fill{circle_about(at, 6.5 * style.unit), white});
  drawing.marks.push_back(Fill{circle_about(at, 4.5 * style.unit), ring_color});
}

/// Next to the ring, in the direction of the true position.
void draw_arrow(Drawing& drawing, const Vec2& at, const Vec2& beyond, const Style& style) {
  const Vec2 along = radius(style) / distance(beyond, {0, 0}) * beyond;
  const auto point = [&](double far, double wide) { return at + far * along + wide * left_of(along); };
  drawing.marks.push_back(Fill{{point(2.7, 0), point(1.1, 1.15), point(1.1, -1.15)}, white});
  drawing.marks.push_back(Fill{{point(2.4, 0), point(1.3, 0.8), point(1.3, -0.8)}, ring_color});
}

// ── Texts ────────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Width below half of that of the picture, except in narrow pictures.
FittedText make_label(const std::string& text, const Box& box, const Style& style) {
  constexpr int many = 99; // lines
  const double full = 0.85 * style.tick_size, wide = 0.9 * (box[1] - box[0]);
  return fit_text(text, full, 0.2 * full, std::min(wide, std::max(0.5 * wide, 8 * full)), many);
}

/// From the marker to the nearest side of the text; empty if they are close to each other.
Polyline leader(const Vec2& at, const Box& place, double size, const Style& style) {
  const Vec2 end = {std::clamp(at[0], place[0], place[1]), std::clamp(at[1], place[2], place[3])};
  const double length = distance(at, end), r = radius(style);
  if (length < arm(style) + 0.6 * size) return {};
  return {at + r / length * (end - at), at + (1 - 0.15 * size / length) * (end - at)};
}

/// Covers a line with small boxes.
std::vector<Box> cover(const Polyline& line, const Style& style) {
  std::vector<Box> boxes;
  if (line.empty()) return boxes;
  const double width = 4 * style.unit;
  const int pieces = static_cast<int>(distance(line[0], line[1]) / width) + 1;
  for (int k = 0; k <= pieces; ++k) {
    const double t = static_cast<double>(k) / pieces;
    boxes.push_back(box_about(line[0] + t * (line[1] - line[0]), 0.5 * width));
  }
  return boxes;
}

/// Areas that later texts must avoid.
struct Taken {
  std::vector<Box> markers, labels;

  bool free(const Box& place) const {
    const auto hit = [&](const Box& other) { return overlap(place, other); };
    return std::none_of(markers.begin(), markers.end(), hit) && std::none_of(labels.begin(), labels.end(), hit);
  }
  bool free(const Polyline& line, const Style& style) const {
    const auto on_label = [&](const Box& piece) {
      return std::any_of(labels.begin(), labels.end(), [&](const Box& label) { return overlap(piece, label); });
    };
    const std::vector<Box> pieces = cover(line, style);
    return std::none_of(pieces.begin(), pieces.end(), on_label);
  }
};

/// The nearest free position out of eight directions around the mark, moved into the box.
std::optional<Box> find_room(const FittedText& label, const Vec2& at, const Box& box, const Taken& taken,
                             const Style& style) {
  // right, left, then the corners, above, below
  static constexpr double directions[][2] = {{1, 0}, {-1, 0}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}, {0, 1}, {0, -1}};
  const double margin = 0.2 * label.size, across = 0.5 * label.width() + margin,
               along = 0.5 * (label.size + label.depth()) + margin;
  for (int step = 0; step <= 9; ++step) {
    const double reach = arm(style) + 1.5 * margin + 0.7 * step * label.size;
    for (const auto& [dx, dy] : directions) {
      const Vec2 middle = {pushed(at[0] + dx * (reach + across - margin), box[0] + across, box[1] - across),
                           pushed(at[1] + dy * (reach + along - margin), box[2] + along, box[3] - along)};
      const Box enlarged = {middle[0] - across, middle[0] + across, middle[1] - along, middle[1] + along};
      const Box place = {enlarged[0] + margin, enlarged[1] - margin, enlarged[2] + margin, enlarged[3] - margin};
      if (holds(box, {place[0], place[2]}) && holds(box, {place[1], place[3]}) && taken.free(enlarged) &&
          taken.free(leader(at, place, label.size, style), style))
        return place;
    }
  }
  return std::nullopt;
}

void draw_label(Drawing& drawing, const FittedText& label, const Box& place, const Style& style) {
  const Vec2 first = {0.5 * (place[0] + place[1]), place[3] - 0.86 * label.size};
  const auto write = [&](double dx, double dy, const Rgb& color) {
    draw_lines(drawing, label, first + Vec2{dx, dy}, Align::center, color);
  };
  const double halo = 2.6 * style.unit;
  for (int k = 0; k < 12; ++k)
    write(halo * std::cos(k * std::numbers::pi / 6), halo * std::sin(k * std::numbers::pi / 6), white);
  write(0, 0, black);
}

} // namespace

std::vector<PlacedMark> within(std::vector<PlacedMark> marks, const Box& box, bool all, const Style& style) {
  const auto inside = [&](const PlacedMark& mark) { return holds(box, mark.at); };
  if (!all) std::erase_if(marks, [&](const PlacedMark& mark) { return !inside(mark); });
  const double space = 2.9 * radius(style); // of ring and arrow
  for (PlacedMark& mark : marks) {
    if (inside(mark)) continue;
    const Vec2 at = {pushed(mark.at[0], box[0] + space, box[1] - space),
                     pushed(mark.at[1], box[2] + space, box[3] - space)};
    mark.beyond = mark.at - at;
    mark.at = at;
  }
  return marks;
}

void draw_marks(Drawing& drawing, const std::vector<PlacedMark>& marks, const Box& box, const Style& style) {
  std::vector<Vec2> rings, dots;
  Taken taken;
  for (const PlacedMark& mark : marks) {
    const auto near = [&](const Vec2& other) { return distance(mark.at, other) < 1.5 * radius(style); };
    const bool ring = std::none_of(rings.begin(), rings.end(), near);
    (ring ? rings : dots).push_back(mark.at);
    taken.markers.push_back(box_about(mark.at, ring ? arm(style) : 0.5 * radius(style)));
  }
  std::vector<std::pair<FittedText, Box>> labels;
  for (const PlacedMark& mark : marks) {
    if (mark.text.empty()) continue;
    FittedText label = make_label(mark.text, box, style);
    const auto place = find_room(label, mark.at, box, taken, style);
    if (!place) continue;
    const Polyline line = leader(mark.at, *place, label.size, style);
    for (const auto& [color, width] : {std::pair{white, 6.0}, std::pair{ring_color, 2.0}})
      if (!line.empty()) drawing.marks.push_back(Stroke{line, color, width * style.unit});
    for (const Box& piece : cover(line, style)) taken.markers.push_back(piece);
    taken.labels.push_back(*place);
    labels.emplace_back(std::move(label), *place);
  }
  for (const Vec2& at : rings) draw_ring(drawing, at, style);
  for (const Vec2& at : dots) draw_dot(drawing, at, style);
  for (const PlacedMark& mark : marks)
    if (mark.beyond != Vec2{0, 0}) draw_arrow(drawing, mark.at, mark.beyond, style);
  for (const auto& [label, place] : labels) draw_label(drawing, label, place, style);
}

} // namespace signorini::view
