#pragma once
// A figure as plain values in pixels, origin at the bottom left, y upwards. Charts and pictures are laid out as a
// Drawing; the writers of PNG, SVG and PDF turn it into bytes.

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace signorini::view {

using Vec2 = std::array<double, 2>;
using Rgb = std::array<std::uint8_t, 3>;

/// An open polyline with round joins. `dash`: lengths of line and gap in turn; empty for a solid line.
struct Stroke {
  std::vector<Vec2> points;
  Rgb colour;
  double width;
  std::vector<double> dash = {};
};

/// A convex polygon.
struct Fill {
  std::vector<Vec2> outline;
  Rgb colour;
};

enum class Align { left, centre, right };

/// One line of UTF-8 text; `at` is the point of the baseline that `align` names.
struct Text {
  Vec2 at;
  std::string string;
  double size;
  Align align = Align::left;
  Rgb colour = {0, 0, 0};
  bool upright = false; ///< reads from bottom to top
};

using Mark = std::variant<Stroke, Fill, Text>;

/// Later marks cover earlier ones; text lies on top of everything.
struct Drawing {
  std::array<int, 2> size;
  std::vector<Mark> marks;
};

/// A triangulated area coloured by interpolated values, beneath all marks. Values outside the range take its end
/// colours.
struct Field {
  std::vector<Vec2> points;
  std::vector<std::array<int, 3>> triangles;
  std::vector<double> values; ///< one per point
  std::array<double, 2> range;
  std::vector<Rgb> colours; ///< evenly spread over the range
};

inline constexpr Rgb black = {0, 0, 0}, white = {255, 255, 255}, ink = {38, 38, 38};

} // namespace signorini::view
