// Obstacles in the plane.

#include "view/obstacle.hpp"

#include "base/index.hpp"
#include "view/surface_lines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace signorini::view {
namespace {

constexpr Rgb rim_colour = {95, 95, 95}, band_colour = {200, 200, 200};
constexpr double small_extent = 280; // pixels of a picture of 1600 × 1000

double corner_distance(const Vec2& a, const Vec2& b) {
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

/// Moves the end away from its neighbour until it lies outside the box, from wherever it is.
void extend(Vec2& end, const Vec2& neighbour, const Box& box) {
  const double length = corner_distance(neighbour, end);
  if (length == 0) return;
  const Vec2 corner = {box[0], box[2]}, opposite = {box[1], box[3]};
  const double factor = (corner_distance(end, corner) + 2 * corner_distance(corner, opposite)) / length;
  for (int axis = 0; axis < 2; ++axis) end[axis] += factor * (end[axis] - neighbour[axis]);
}

/// Strokes at 45° to the line, on its left, one after each `spacing` pixels.
void hatch(Drawing& drawing, const std::vector<Vec2>& line, const Box& box, const Style& style) {
  const double spacing = 14 * style.unit, length = 18 * style.unit;
  double next = 0.5 * spacing; // to the next stroke
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double size = corner_distance(line[i - 1], line[i]);
    if (size == 0) continue;
    const Vec2 t = {(line[i][0] - line[i - 1][0]) / size, (line[i][1] - line[i - 1][1]) / size};
    while (next < size) {
      const Vec2 from = {line[i - 1][0] + next * t[0], line[i - 1][1] + next * t[1]};
      // (t + n)/√2 with the left normal n = (−t_y, t_x)
      const Vec2 to = {from[0] + std::sqrt(0.5) * length * (t[0] - t[1]),
                       from[1] + std::sqrt(0.5) * length * (t[1] + t[0])};
      for (auto& part : clip_line({from, to}, box))
        drawing.marks.push_back(Stroke{std::move(part), rim_colour, 1.8 * style.unit});
      next += spacing;
    }
    next -= size;
  }
}

/// A grey band on the left of the line: on small obstacles hatching looks like marks.
void shade(Drawing& drawing, const std::vector<Vec2>& line, double width) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 &a = line[i - 1], &b = line[i];
    const double size = corner_distance(a, b);
    if (size == 0) continue;
    const Vec2 inwards = {-width * (b[1] - a[1]) / size, width * (b[0] - a[0]) / size};
    drawing.marks.push_back(
        Fill{{a, b, {b[0] + inwards[0], b[1] + inwards[1]}, {a[0] + inwards[0], a[1] + inwards[1]}}, band_colour});
  }
}

/// The longer side of what a line covers.
double extent_of(const std::vector<Vec2>& line) {
  double extent = 0;
  for (std::size_t axis : {0, 1}) {
    const auto [low, high] =
        std::minmax_element(line.begin(), line.end(), [&](const Vec2& a, const Vec2& b) { return a[axis] < b[axis]; });
    extent = std::max(extent, (*high)[axis] - (*low)[axis]);
  }
  return extent;
}

} // namespace

Outline half_plane(const Vec<2>& point, const Vec<2>& normal) {
  Outline outline;
  outline.endless = true;
  // −n is on the left of t = (−n_y, n_x)
  const Vec<2> along = Vec<2>(-normal[1], normal[0]);
  outline.line.setZero(3, 2);
  outline.line.col(0).head<2>() = point;
  outline.line.col(1).head<2>() = point + along;
  return outline;
}

Outline circle(const Vec<2>& centre, double radius, const std::vector<Window>& windows) {
  const auto place = [&](double fraction) {
    const double angle = 2 * std::numbers::pi * fraction;
    return Vec<3>(centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle), 0);
  };
  return outline(place, 180, windows);
}

Outline outline(const std::function<Vec<3>(double)>& place, int pieces, const std::vector<Window>& windows) {
  std::vector<double> fractions = even_cuts(pieces);
  for (int k = 0; k < pieces && !windows.empty(); ++k) {
    const auto piece = [&](double s, double) { return place((k + s) / pieces); };
    const auto cuts = window_cuts(piece, windows, false);
    for (double cut : cuts[0]) fractions.push_back((k + cut) / pieces);
  }
  add_cuts(fractions, {});
  Outline outline{Points(3, static_cast<Eigen::Index>(fractions.size()))};
  for (Eigen::Index i = 0; i < outline.line.cols(); ++i)
    outline.line.col(i) = place(fractions[at(static_cast<int>(i))]);
  return outline;
}

Outline mirrored(const Outline& outline, int axis) {
  Outline image = outline;
  image.line = outline.line.rowwise().reverse(); // left stays left
  image.line.row(axis) *= -1;
  return image;
}

void draw_obstacle(Drawing& drawing, const Outline& outline, const Box& box, const Style& style) {
  std::vector<Vec2> line = flat(outline.line);
  if (line.size() < 2) return;
  if (outline.endless) {
    const Vec2 first = line.front();
    extend(line.front(), line[1], box);
    extend(line.back(), line.size() == 2 ? first : line[line.size() - 2], box);
  }
  const double extent = extent_of(line);
  const bool small = !outline.endless && extent < small_extent * style.unit;
  for (auto& part : clip_line(line, box)) {
    if (small)
      shade(drawing, part, std::min(9 * style.unit, 0.15 * extent));
    else
      hatch(drawing, part, box, style);
    drawing.marks.push_back(Stroke{std::move(part), rim_colour, 3.6 * style.unit});
  }
}

Points worth_showing(const Outline& outline, const Bounds& box) {
  const Vec<2> size = (box.high - box.low).head<2>(), centre = box.centre().head<2>();
  const auto& line = outline.line;
  if (line.cols() < 2) return {};
  if (!outline.endless) {
    const Vec<3> extent = line.rowwise().maxCoeff() - line.rowwise().minCoeff();
    return extent.maxCoeff() <= size.maxCoeff() ? line : Points();
  }
  // The foot of the box's centre on the straight line through the ends
  const Vec<2> start = line.col(0).head<2>(), along = (line.col(line.cols() - 1).head<2>() - start).normalized();
  Points foot = Points::Zero(3, 1);
  foot.col(0).head<2>() = start + along.dot(centre - start) * along;
  const Vec<2> away = (foot.col(0).head<2>() - centre).cwiseAbs() - 0.5 * size;
  return away.maxCoeff() <= 0.5 * size.maxCoeff() ? foot : Points();
}

} // namespace signorini::view
