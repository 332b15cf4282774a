#include "view/strokes.hpp"

#include <algorithm>

namespace signorini::view {
namespace {

Vec2 mix(const Vec2& a, const Vec2& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
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

} // namespace signorini::view
