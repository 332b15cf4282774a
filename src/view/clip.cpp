#include "view/clip.hpp"

#include "base/index.hpp"

namespace signorini::view {
namespace {

struct ClippedCorner {
  Vec2 at;
  double value;
};

/// The corners of a convex polygon on one side of a limit, by Sutherland and Hodgman: sign · (coordinate − limit) ≥ 0.
std::vector<ClippedCorner> cut(const std::vector<ClippedCorner>& polygon, int axis, double limit, double sign) {
  std::vector<ClippedCorner> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ClippedCorner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double from = sign * (a.at[axis] - limit), to = sign * (b.at[axis] - limit);
    if (from >= 0) result.push_back(a);
    if ((from < 0) == (to < 0)) continue;
    const double t = from / (from - to);
    result.push_back(
        {{a.at[0] + t * (b.at[0] - a.at[0]), a.at[1] + t * (b.at[1] - a.at[1])}, a.value + t * (b.value - a.value)});
  }
  return result;
}

} // namespace

Field clip_field(const Field& field, const Box& box) {
  Field result{{}, {}, {}, field.range, field.colours};
  for (const auto& triangle : field.triangles) {
    std::vector<ClippedCorner> polygon;
    polygon.reserve(triangle.size());
    for (int corner : triangle) polygon.push_back({field.points[corner], field.values[corner]});
    for (int axis = 0; axis < 2; ++axis) {
      polygon = cut(polygon, axis, box[at(2 * axis)], 1);
      polygon = cut(polygon, axis, box[at(2 * axis + 1)], -1);
    }
    const int first = static_cast<int>(result.points.size());
    for (const auto& [place, value] : polygon) result.points.push_back(place), result.values.push_back(value);
    for (int k = 2; k < static_cast<int>(polygon.size()); ++k)
      result.triangles.push_back({first, first + k - 1, first + k});
  }
  return result;
}

} // namespace signorini::view
