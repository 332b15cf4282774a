#include "view/panel.hpp"

#include "base/index.hpp"
#include "view/cut.hpp"

#include <cmath>
#include <numbers>
#include <utility>

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
  for (Points* points : {&image.points, &image.vectors, &image.control_points}) flip(*points, axis);
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

void join_at_mirror(Body& body, int axis) {
  const auto beyond = crossed_mirror(body.points, axis);
  if (!beyond) return;
  static_cast<Surface&>(body) = cut(body, *beyond, 0);
  const auto parts = [&](const Points& line) {
    return cut(SurfaceLine{line, Points::Zero(3, line.cols())}, *beyond, 0);
  };
  for (auto* lines : {&body.rim, &body.undeformed})
    for (const Points& line : std::exchange(*lines, {}))
      for (SurfaceLine& part : parts(line)) lines->push_back(std::move(part.points));
  for (const MeshLine& line : std::exchange(body.mesh_lines, {}))
    for (SurfaceLine& part : parts(line.points)) body.mesh_lines.push_back({std::move(part.points), line.spacing});
}

PointVector mirrored(PointVector vector, int axis) {
  vector.at[axis] *= -1, vector.vector[axis] *= -1;
  return vector;
}

std::vector<Vec2> on_paper(const Points& points, const Frame& frame) {
  std::vector<Vec2> result;
  for (Eigen::Index i = 0; i < points.cols(); ++i) result.push_back({frame.x(points(0, i)), frame.y(points(1, i))});
  return result;
}

} // namespace signorini::view
