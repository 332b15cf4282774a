#include "view/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace signorini::view {
namespace {

/// The part [t0, t1] of a segment inside the box, by Liang and Barsky; false if empty.
bool inside(const Vec2& a, const Vec2& b, const Box& box, double& t0, double& t1) {
  t0 = 0, t1 = 1;
  for (int axis = 0; axis < 2; ++axis)
    for (int end = 0; end < 2; ++end) {
      const double sign = end == 0 ? -1 : 1;
      const double slope = sign * (b[axis] - a[axis]), space = sign * (box[2 * axis + end] - a[axis]);
      if (slope == 0 && space < 0) return false;
      if (slope < 0) t0 = std::max(t0, space / slope);
      if (slope > 0) t1 = std::min(t1, space / slope);
    }
  return t0 <= t1;
}

} // namespace

std::vector<std::vector<Vec2>> clip_line(const std::vector<Vec2>& line, const Box& box) {
  std::vector<std::vector<Vec2>> parts;
  bool joined = false; // whether the next segment continues the last part
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto along = [&](double t) { return line[i - 1] + t * (line[i] - line[i - 1]); };
    double t0, t1;
    if (!inside(line[i - 1], line[i], box, t0, t1)) {
      joined = false;
      continue;
    }
    if (!joined || t0 > 0) parts.push_back({along(t0)});
    parts.back().push_back(t1 < 1 ? along(t1) : line[i]);
    joined = t1 == 1;
  }
  return parts;
}

void add_line(Drawing& drawing, const std::vector<Vec2>& line, const Box& box, const Rgb& color, double width,
              const std::vector<double>& dash) {
  for (auto& part : clip_line(line, box)) drawing.marks.push_back(Stroke{std::move(part), color, width, dash});
}

std::vector<Vec2> clip_polygon(std::vector<Vec2> outline, const Box& box) {
  for (int side = 0; side < 4; ++side) { // by Sutherland and Hodgman
    const auto beyond = [&](const Vec2& p) { return (side % 2 == 0 ? -1 : 1) * (p[side / 2] - box[side]); };
    std::vector<Vec2> kept;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
      const double from = beyond(a), to = beyond(b);
      if (from <= 0) kept.push_back(a);
      if (from * to < 0) kept.push_back(a + from / (from - to) * (b - a));
    }
    outline = std::move(kept);
  }
  return outline;
}

std::vector<Vec2> circle_about(const Vec2& at, double radius) {
  constexpr int pieces = 48;
  std::vector<Vec2> circle;
  for (int k = 0; k <= pieces; ++k) {
    const double angle = 2 * std::numbers::pi * k / pieces;
    circle.push_back(at + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return circle;
}

std::vector<Vec2> outline_of(const Box& box) {
  const auto& [left, right, bottom, top] = box;
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}, {left, bottom}, {right, bottom}};
}

void draw_arrow(Drawing& drawing, std::vector<Vec2> line, double head, double width, const Rgb& color) {
  const Vec2 tip = line.back();
  while (line.size() > 1 && distance(tip, line.back()) < head) line.pop_back();
  const double length = distance(tip, line.back());
  if (length == 0) return;
  const Vec2 along = head / length * (tip - line.back()), neck = tip - along, side = 0.4 * left_of(along);
  line.push_back(neck);
  drawing.marks.push_back(Stroke{std::move(line), color, width});
  drawing.marks.push_back(Fill{{tip, neck + side, neck - side}, color});
}

Box clipped(const Box& box, const Box& frame) {
  return {std::max(box[0], frame[0]), std::min(box[1], frame[1]), std::max(box[2], frame[2]),
          std::min(box[3], frame[3])};
}

Box enlarged(const Box& box, double margin) {
  return {box[0] - margin, box[1] + margin, box[2] - margin, box[3] + margin};
}

bool overlap(const Box& a, const Box& b) {
  return a[0] < b[1] && b[0] < a[1] && a[2] < b[3] && b[2] < a[3];
}

bool holds(const Box& box, const Vec2& point) {
  return point[0] >= box[0] && point[0] <= box[1] && point[1] >= box[2] && point[1] <= box[3];
}

} // namespace signorini::view
