#include "view/surface_lines.hpp"

#include "base/error.hpp"
#include "view/categories.hpp"
#include "view/frame.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace signorini::view {
namespace {

constexpr Rgb light_line = {205, 205, 205};
constexpr double darkest = 40; // CIE L* of the darkest colors on which dark lines are visible

} // namespace

std::vector<Vec2> flat(const Points& points) {
  std::vector<Vec2> line;
  for (const auto& point : points.colwise()) line.push_back({point[0], point[1]});
  return line;
}

Rgb color_of(double value, const std::array<double, 2>& range, const std::vector<Rgb>& colors) {
  const double last = static_cast<double>(colors.size() - 1), t = (value - range[0]) / (range[1] - range[0]);
  return colors[static_cast<std::size_t>(std::lround(std::clamp(t * last, 0.0, last)))];
}

Rgb tone_on(const Rgb& surface) {
  return lightness(surface) < darkest ? light_line : border_color;
}

std::vector<double> contour_levels(const Contours& contours, const std::array<double, 2>& range,
                                   const std::array<double, 2>& values) {
  constexpr int numbers = 9; // at most
  std::vector<double> levels = contours.levels;
  if (levels.empty() && contours.count == 0) levels = linear_ticks(range[0], range[1], numbers).at;
  for (int k = 1; k <= contours.count; ++k)
    levels.push_back(range[0] + k * (range[1] - range[0]) / (contours.count + 1));
  require(contours.levels.empty() || std::any_of(levels.begin(), levels.end(),
                                                 [&](double level) { return level > values[0] && level < values[1]; }),
          "view.contours.none", {{"low", values[0]}, {"high", values[1]}});
  return levels;
}

std::vector<PointVector> regular_sample(const std::vector<Surface>& surfaces, double step) {
  std::map<std::array<int, 2>, PointVector> seen;
  for (const Surface& surface : surfaces)
    for (const auto& corners : surface.triangles.colwise()) {
      const Mat<3> at = surface.points(Eigen::all, corners);
      if (surface.normals.cols() > 0 && surface.normals.row(2)(corners).sum() <= 0) continue;
      const Vec<2> low = at.topRows<2>().rowwise().minCoeff() / step,
                   high = at.topRows<2>().rowwise().maxCoeff() / step;
      Mat<3> system = at;
      system.row(2).setOnes();
      if (std::abs(system.determinant()) < 1e-9) continue;
      const Mat<3> inverse = system.inverse();
      for (int i = static_cast<int>(std::ceil(low[0])); i <= high[0]; ++i)
        for (int j = static_cast<int>(std::ceil(low[1])); j <= high[1]; ++j) {
          const Vec<3> weights = inverse * Vec<3>(i * step, j * step, 1);
          if (weights.minCoeff() < -1e-9) continue;
          PointVector one{at * weights, Vec<3>::Zero()};
          if (surface.vectors.cols() > 0) one.vector = Mat<3>(surface.vectors(Eigen::all, corners)) * weights;
          const auto [there, fresh] = seen.try_emplace({i, j}, one);
          if (!fresh && there->second.at[2] < one.at[2]) there->second = one;
        }
    }
  std::vector<PointVector> sample;
  sample.reserve(seen.size());
  for (const auto& [place, one] : seen) sample.push_back(one);
  return sample;
}

void draw_vectors(Drawing& drawing, const std::vector<PointVector>& vectors, double scale, const Box& box,
                  double unit) {
  for (const auto& [at, vector] : vectors) {
    const Vec2 from = {at[0], at[1]}, to = from + scale * Vec2{vector[0], vector[1]};
    const double length = distance(from, to);
    if (length < 4 * unit || !holds(box, from)) continue;
    // White outline, visible on any color.
    const double head = std::min(15 * unit, 0.6 * length);
    draw_arrow(drawing, {from, to}, head + 3 * unit, 6 * unit, white);
    draw_arrow(drawing, {from, to}, head, 2.6 * unit, ink);
  }
}

} // namespace signorini::view
