#include "view/strokes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace signorini::view {
namespace {

Vec2 mix(const Vec2& a, const Vec2& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
}
double distance(const Vec2& a, const Vec2& b) {
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

/// The stretch [t0, t1] of a segment inside the box, by Liang and Barsky; false when there is none.
bool inside(const Vec2& a, const Vec2& b, const Box& box, double& t0, double& t1) {
  t0 = 0, t1 = 1;
  for (int axis = 0; axis < 2; ++axis)
    for (int end = 0; end < 2; ++end) {
      const double sign = end == 0 ? -1 : 1;
      const double slope = sign * (b[axis] - a[axis]), room = sign * (box[2 * axis + end] - a[axis]);
      if (slope == 0 && room < 0) return false;
      if (slope < 0) t0 = std::max(t0, room / slope);
      if (slope > 0) t1 = std::min(t1, room / slope);
    }
  return t0 <= t1;
}

void add_disc(std::vector<Vec2>& triangles, const Vec2& centre, double radius) {
  const int corners = std::clamp(static_cast<int>(4 * std::sqrt(radius)) + 6, 8, 64);
  const auto corner = [&](int k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    return Vec2{centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)};
  };
  for (int k = 0; k < corners; ++k) triangles.insert(triangles.end(), {centre, corner(k), corner(k + 1)});
}

} // namespace

std::vector<std::vector<Vec2>> clip_line(const std::vector<Vec2>& line, const Box& box) {
  std::vector<std::vector<Vec2>> parts;
  bool joined = false; // does the next segment go on from the last part's end?
  for (std::size_t i = 1; i < line.size(); ++i) {
    double t0, t1;
    if (!inside(line[i - 1], line[i], box, t0, t1)) {
      joined = false;
      continue;
    }
    if (!joined || t0 > 0) parts.push_back({mix(line[i - 1], line[i], t0)});
    parts.back().push_back(t1 < 1 ? mix(line[i - 1], line[i], t1) : line[i]);
    joined = t1 == 1;
  }
  return parts;
}

std::vector<std::vector<Vec2>> dash_line(const std::vector<Vec2>& line, const std::vector<double>& pattern) {
  if (pattern.empty()) return {line};
  std::vector<std::vector<Vec2>> parts;
  std::size_t phase = 0; // even: line, odd: gap
  double left = pattern[0];
  if (!line.empty()) parts.push_back({line.front()});
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double length = distance(line[i - 1], line[i]);
    double done = 0;
    while (length - done > left) {
      done += left;
      const Vec2 point = mix(line[i - 1], line[i], done / length);
      if (phase % 2 == 0)
        parts.back().push_back(point);
      else
        parts.push_back({point});
      phase = (phase + 1) % pattern.size();
      left = pattern[phase];
    }
    left -= length - done;
    if (phase % 2 == 0) parts.back().push_back(line[i]);
  }
  return parts;
}

std::vector<Vec2> stroke_triangles(const Stroke& stroke) {
  std::vector<Vec2> triangles;
  const double half = 0.5 * stroke.width;
  for (const auto& part : dash_line(stroke.points, stroke.dash))
    for (std::size_t i = 1; i < part.size(); ++i) {
      const Vec2 &a = part[i - 1], &b = part[i];
      const double length = distance(a, b);
      if (length == 0) continue;
      const double nx = half * (a[1] - b[1]) / length, ny = half * (b[0] - a[0]) / length;
      const Vec2 a1 = {a[0] + nx, a[1] + ny}, a2 = {a[0] - nx, a[1] - ny};
      const Vec2 b1 = {b[0] + nx, b[1] + ny}, b2 = {b[0] - nx, b[1] - ny};
      triangles.insert(triangles.end(), {a1, a2, b2, a1, b2, b1});
      if (i + 1 < part.size()) add_disc(triangles, b, half);
    }
  return triangles;
}

} // namespace signorini::view
