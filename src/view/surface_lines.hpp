#pragma once
// Lines and arrows that pictures draw on colored surfaces.

#include "view/panel.hpp"

#include <unordered_map>

namespace signorini::view {

/// Points without their z.
std::vector<Vec2> flat(const Points& points);

/// The color of a value in a range of colors; beyond it that of the nearest end.
Rgb color_of(double value, const std::array<double, 2>& range, const std::vector<Rgb>& colors);

/// Dark lines vanish on dark colors, light ones on light colors: the one that shows.
Rgb tone_on(const Rgb& ground);

/// What lies beneath lines that run through a surface's own points.
class Ground {
public:
  explicit Ground(const Surface& surface);
  /// One value per point of the line; none where the surface has none.
  VectorX along(const Points& line) const;

private:
  struct Hash {
    std::size_t operator()(const std::array<double, 3>& point) const;
  };
  std::unordered_map<std::array<double, 3>, double, Hash> values_;
};

/// A part of a line in one color.
struct Stretch {
  Eigen::Index first, count; ///< of the line's points
  Rgb color;
};
/// A line in the tones that show on the values beneath it; whole in one color where there are no values.
std::vector<Stretch> toned(Eigen::Index points, const VectorX& values, const Rgb& otherwise,
                           const std::array<double, 2>& range, const std::vector<Rgb>& colors);

/// Which values contour lines stand for.
struct Contours {
  int count = 0;                   ///< evenly spread within the range of colors; 0: at the color bar's numbers
  std::vector<double> levels = {}; ///< in their place

  bool operator==(const Contours&) const = default;
};
/// Rising; throws Error where none of the levels is a value that is drawn, from the lowest to the highest.
std::vector<double> contour_levels(const Contours& contours, const std::array<double, 2>& range,
                                   const std::array<double, 2>& values);

/// The vectors of surfaces in pixels, z towards the eye, at the points of a square grid that the eye sees, `step`
/// apart.
std::vector<PointVector> regular_sample(const std::vector<Surface>& surfaces, double step);

/// Arrows along vectors, `scale` pixels per unit, that begin within the box.
void draw_vectors(Drawing& drawing, const std::vector<PointVector>& vectors, double scale, const Box& box, double unit);

} // namespace signorini::view
