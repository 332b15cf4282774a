#include "view/markers.hpp"

#include <cmath>
#include <numbers>

namespace signorini::view {
namespace {

/// Regular polygons of about equal area, or crosses where there are no corners.
struct Shape {
  int corners;
  double turn;  ///< of the first corner, in degrees
  double scale; ///< of the radius
};

constexpr Shape shapes[] = {{20, 0, 1.0},  {4, 45, 1.25}, {3, 90, 1.4}, {4, 90, 1.25},
                            {3, -90, 1.4}, {0, 45, 1.2},  {5, 90, 1.2}, {0, 0, 1.2}};

std::vector<Vec2> ring(const Shape& shape, const Vec2& at, double radius, int corners) {
  std::vector<Vec2> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = (shape.turn + 360.0 * k / corners) * std::numbers::pi / 180;
    points.push_back({at[0] + radius * std::cos(angle), at[1] + radius * std::sin(angle)});
  }
  return points;
}

void draw_cross(Drawing& drawing, const Shape& shape, const Vec2& at, double radius, double width, const Rgb& colour) {
  const auto ends = ring(shape, at, radius, 4);
  drawing.marks.push_back(Stroke{{ends[0], ends[2]}, colour, width});
  drawing.marks.push_back(Stroke{{ends[1], ends[3]}, colour, width});
}

} // namespace

void draw_marker(Drawing& drawing, int shape, const Vec2& at, double radius, const Rgb& colour) {
  const Shape& s = shapes[shape % 8];
  const double size = s.scale * radius, rim = 0.22 * radius;
  if (s.corners == 0) {
    draw_cross(drawing, s, at, size + rim, 0.55 * radius + 2 * rim, white);
    draw_cross(drawing, s, at, size, 0.55 * radius, colour);
    return;
  }
  // A polygon grows by rim on each side when its corners move out by rim / cos(π/n).
  drawing.marks.push_back(Fill{ring(s, at, size + rim / std::cos(std::numbers::pi / s.corners), s.corners), white});
  drawing.marks.push_back(Fill{ring(s, at, size, s.corners), colour});
}

} // namespace signorini::view
