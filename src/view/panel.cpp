#include "view/panel.hpp"

#include "base/index.hpp"

#include <cmath>
#include <numbers>

namespace signorini::view {
namespace {

void flip(Points& points, int axis) {
  points.row(axis) *= -1;
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

Body mirrored(const Body& body, int axis, double sign) {
  Body image = body;
  flip(image.points, axis);
  flip(image.control_points, axis);
  for (MeshLine& line : image.mesh_lines) flip(line.points, axis);
  for (Points& line : image.rim) flip(line, axis);
  for (Points& line : image.undeformed) flip(line, axis);
  image.values *= sign;
  return image;
}

Outline mirrored(const Outline& outline, int axis) {
  Outline image = outline;
  image.line = outline.line.rowwise().reverse(); // left stays left
  flip(image.line, axis);
  return image;
}

std::vector<Vec2> on_paper(const Points& points, const Frame& frame) {
  std::vector<Vec2> result;
  for (Eigen::Index i = 0; i < points.cols(); ++i) result.push_back({frame.x(points(0, i)), frame.y(points(1, i))});
  return result;
}

} // namespace signorini::view
