#pragma once
// Lines and arrows on colored surfaces.

#include "view/panel.hpp"

namespace signorini::view {

/// Points without their z.
std::vector<Vec2> flat(const Points& points);

/// The color of a value; the nearest end color outside the range.
Rgb color_of(double value, const std::array<double, 2>& range, const std::vector<Rgb>& colors);

/// Dark or light line color, whichever has more contrast with the surface color.
Rgb tone_on(const Rgb& surface);

/// The values of contour lines.
struct Contours {
  int count = 0;                   ///< number, evenly spaced within the color range; 0: at the numbers of the color bar
  std::vector<double> levels = {}; ///< explicit values instead

  bool operator==(const Contours&) const = default;
};
/// Ascending; throws Error when no level lies between the minimum and maximum of the drawn values.
std::vector<double> contour_levels(const Contours& contours, const std::array<double, 2>& range,
                                   const std::array<double, 2>& values);

/// The visible vectors of surfaces in pixels, z towards the eye, on a square grid of spacing `step`.
std::vector<PointVector> regular_sample(const std::vector<Surface>& surfaces, double step);

/// Arrows along vectors, `scale` pixels per unit, that start within the box.
void draw_vectors(Drawing& drawing, const std::vector<PointVector>& vectors, double scale, const Box& box, double unit);

} // namespace signorini::view
