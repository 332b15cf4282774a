#pragma once
// A figure as plain values in pixels, origin at the bottom left, y upwards. Charts and pictures are laid out as a
// Drawing; the writers of PNG, SVG and PDF convert it into bytes.

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace signorini::view {

using Vec2 = std::array<double, 2>;
inline Vec2 operator+(const Vec2& a, const Vec2& b) {
  return {a[0] + b[0], a[1] + b[1]};
}
inline Vec2 operator-(const Vec2& a, const Vec2& b) {
  return {a[0] - b[0], a[1] - b[1]};
}
inline Vec2 operator*(double factor, const Vec2& v) {
  return {factor * v[0], factor * v[1]};
}
/// Rotates by 90° counterclockwise.
inline Vec2 left_of(const Vec2& v) {
  return {-v[1], v[0]};
}
inline double distance(const Vec2& a, const Vec2& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

using Rgb = std::array<std::uint8_t, 3>;
using Box = std::array<double, 4>; ///< xmin, xmax, ymin, ymax

/// An open polyline with round joins. `dash`: alternating lengths of dash and gap; empty: solid.
struct Stroke {
  std::vector<Vec2> points;
  Rgb color;
  double width;
  std::vector<double> dash = {};
};

/// A polygon that does not overlap itself.
struct Fill {
  std::vector<Vec2> outline;
  Rgb color;
  double opacity = 1;
};

enum class Align { left, center, right };

/// One line of UTF-8 text; `at` is the point of the baseline given by `align`.
struct Text {
  Vec2 at;
  std::string string;
  double size;
  Align align = Align::left;
  Rgb color = {0, 0, 0};
  bool upright = false; ///< reads from bottom to top
};

using Mark = std::variant<Stroke, Fill, Text>;

/// Later marks cover earlier ones; text is drawn last.
struct Drawing {
  std::array<int, 2> size;
  std::vector<Mark> marks;
};

inline constexpr Rgb black = {0, 0, 0}, white = {255, 255, 255}, ink = {38, 38, 38};

/// The parts of a polyline inside the box.
std::vector<std::vector<Vec2>> clip_line(const std::vector<Vec2>& line, const Box& box);

/// The parts of a line inside the box.
void add_line(Drawing& drawing, const std::vector<Vec2>& line, const Box& box, const Rgb& color, double width,
              const std::vector<double>& dash = {});

/// The part of a polygon inside the box; several parts are joined along the sides of the box.
std::vector<Vec2> clip_polygon(std::vector<Vec2> outline, const Box& box);

/// Rims as closed lines.
std::vector<Vec2> circle_about(const Vec2& at, double radius);
std::vector<Vec2> outline_of(const Box& box);

/// A line with an arrow head of this length; the shaft ends at the head.
void draw_arrow(Drawing& drawing, std::vector<Vec2> line, double head, double width, const Rgb& color);

/// The intersection of two boxes, and a box enlarged on all sides.
Box clipped(const Box& box, const Box& frame);
Box enlarged(const Box& box, double margin);

bool overlap(const Box& a, const Box& b);
bool holds(const Box& box, const Vec2& point);

} // namespace signorini::view
