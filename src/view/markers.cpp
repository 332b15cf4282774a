// Data points as small signs.

#include "view/curves.hpp"

#include <cmath>
#include <numbers>

namespace signorini::view {
namespace {

/// Regular polygons of about equal area, or crosses where there are no corners.
struct Shape {
  const char* name;
  int corners;
  bool open;
  double turn;  ///< of the first corner, in degrees
  double scale; ///< of the radius
};

// An open cross would look like a full one; other polygons stand for them.
constexpr Shape shapes[] = {{"circle", 20, false, 0, 1.0},
                            {"square", 4, false, 45, 1.25},
                            {"triangle", 3, false, 90, 1.4},
                            {"diamond", 4, false, 90, 1.25},
                            {"triangle down", 3, false, -90, 1.4},
                            {"cross", 0, false, 45, 1.2},
                            {"pentagon", 5, false, 90, 1.2},
                            {"plus", 0, false, 0, 1.2},
                            {"open circle", 20, true, 0, 1.0},
                            {"open square", 4, true, 45, 1.25},
                            {"open triangle", 3, true, 90, 1.4},
                            {"open diamond", 4, true, 90, 1.25},
                            {"open triangle down", 3, true, -90, 1.4},
                            {"open hexagon", 6, true, 0, 1.15},
                            {"open pentagon", 5, true, 90, 1.2},
                            {"open pentagon down", 5, true, -90, 1.2}};
constexpr int count = sizeof shapes / sizeof shapes[0];

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

const std::vector<std::string>& marker_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Shape& shape : shapes) list.emplace_back(shape.name);
    return list;
  }();
  return names;
}

void draw_marker(Drawing& drawing, int marker, const Vec2& at, double radius, const Rgb& colour) {
  const Shape& s = shapes[marker % count];
  const double size = s.scale * radius, rim = 0.22 * radius;
  if (s.corners == 0) {
    draw_cross(drawing, s, at, size + rim, 0.55 * radius + 2 * rim, white);
    draw_cross(drawing, s, at, size, 0.55 * radius, colour);
    return;
  }
  // A polygon grows by rim on each side when its corners move out by rim / cos(π/n).
  const double out = 1 / std::cos(std::numbers::pi / s.corners);
  const auto fill = [&](double grown, const Rgb& c) {
    drawing.marks.push_back(Fill{ring(s, at, size + grown * out, s.corners), c});
  };
  fill(rim, white);
  fill(0, colour);
  if (s.open) fill(-0.36 * radius, white);
}

} // namespace signorini::view
