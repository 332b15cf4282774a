// Obstacles in space, cut to the box of what they touch.

#include "view/obstacle.hpp"

#include "base/index.hpp"
#include "view/cut.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace signorini::view {
namespace {

Vec<3> flipped(Vec<3> v, int axis) {
  v[axis] = -v[axis];
  return v;
}

bool same(const Vec<3>& a, const Vec<3>& b, double size) {
  return (a - b).norm() <= 1e-9 * size;
}

/// Even pieces in two directions, and more where windows need them.
template <class Place>
std::array<std::vector<double>, 2> fractions(std::array<int, 2> pieces, const std::vector<Window>& windows,
                                             const Place& place) {
  std::array<std::vector<double>, 2> result = {even_cuts(pieces[0]), even_cuts(pieces[1])};
  for (int j = 0; j < pieces[1] && !windows.empty(); ++j)
    for (int i = 0; i < pieces[0]; ++i) {
      const auto at_piece = [&](double s, double t) { return place((i + s) / pieces[0], (j + t) / pieces[1]).first; };
      const auto cuts = window_cuts(at_piece, windows, false);
      for (double cut : cuts[0]) result[0].push_back((i + cut) / pieces[0]);
      for (double cut : cuts[1]) result[1].push_back((j + cut) / pieces[1]);
    }
  for (std::vector<double>& all : result) add_cuts(all, {});
  return result;
}

/// A surface over columns × rows pieces of a rectangle of parameters, and more where windows need them; `place` gives
/// point and normal at (u, v), both 0 … 1.
template <class Place>
Surface tessellated(std::array<int, 2> pieces, const std::vector<Window>& windows, const Place& place) {
  Surface surface;
  const auto [us, vs] = fractions(pieces, windows, place);
  const int columns = static_cast<int>(us.size()) - 1, rows = static_cast<int>(vs.size()) - 1, side = columns + 1,
            count = side * (rows + 1), triangles = 2 * columns * rows;
  surface.points.resize(3, count);
  surface.normals.resize(3, surface.points.cols());
  surface.triangles.resize(3, triangles);
  for (int j = 0, triangle = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const auto [point, normal] = place(us[at(i)], vs[at(j)]);
      const int here = i + side * j;
      surface.points.col(here) = point;
      surface.normals.col(here) = normal;
      if (i == columns || j == rows) continue;
      surface.triangles.col(triangle++) << here, here + 1, here + side + 1;
      surface.triangles.col(triangle++) << here, here + side + 1, here + side;
    }
  return surface;
}

/// Two unit vectors across a unit vector.
std::array<Vec<3>, 2> across(const Vec<3>& direction) {
  const Vec<3> first = direction.unitOrthogonal();
  return {first, direction.cross(first)};
}

using Place = std::pair<Vec<3>, Vec<3>>;

/// A square of the plane that is larger than the box, about the point nearest to the box's middle, which is one of its
/// corners.
RigidSurface whole(const RigidPlane& plane, const Bounds& box, const std::vector<Window>&) {
  const Vec<3> normal = plane.normal.normalized(),
               foot = box.centre() - normal.dot(box.centre() - plane.point) * normal;
  const auto [a, b] = across(normal);
  const double half = 3 * (box.high - box.low).norm();
  const Surface square = tessellated({2, 2}, {}, [&, a = a, b = b](double u, double v) {
    return Place{foot + half * ((2 * u - 1) * a + (2 * v - 1) * b), normal};
  });
  return {square, {}};
}

RigidSurface whole(const RigidBall& ball, const Bounds&, const std::vector<Window>& windows) {
  const Surface sphere = tessellated({96, 48}, windows, [&](double u, double v) {
    const double length = 2 * std::numbers::pi * u, height = std::numbers::pi * (v - 0.5);
    const Vec<3> out{std::cos(height) * std::cos(length), std::cos(height) * std::sin(length), std::sin(height)};
    return Place{ball.centre + ball.radius * out, out};
  });
  return {sphere, {}};
}

/// As long as the box is along its axis, with a little air.
RigidSurface whole(const RigidCylinder& cylinder, const Bounds& box, const std::vector<Window>& windows) {
  const Vec<3> axis = cylinder.axis.normalized(),
               middle = cylinder.point + axis.dot(box.centre() - cylinder.point) * axis;
  const double half = 0.5 * axis.cwiseAbs().dot(box.high - box.low) + 0.05 * box.size();
  const auto [a, b] = across(axis);
  RigidSurface result;
  const auto place = [&, a = a, b = b](double u, double v) {
    const double angle = 2 * std::numbers::pi * u;
    const Vec<3> out = std::cos(angle) * a + std::sin(angle) * b;
    return Place{middle + (2 * v - 1) * half * axis + cylinder.radius * out, out};
  };
  constexpr int pieces = 128;
  result.surface = tessellated({pieces, 2}, windows, place);
  for (int end : {0, 1}) {
    const std::vector<double> way = fractions({pieces, 2}, windows, place)[0];
    const int count = static_cast<int>(way.size());
    SurfaceLine circle{Points(3, count), Points(3, count)};
    for (int i = 0; i < count; ++i) {
      const auto [point, normal] = place(way[at(i)], end);
      circle.points.col(i) = point;
      circle.normals.col(i) = normal;
    }
    result.rim.push_back(std::move(circle));
  }
  return result;
}

RigidSurface whole(const RigidSurface& surface, const Bounds&, const std::vector<Window>&) {
  return surface;
}

/// What lies within the box; where it is cut it gets a rim.
RigidSurface within(RigidSurface rigid, const Bounds& box) {
  const double tolerance = 1e-9 * box.size();
  for (int axis = 0; axis < 3; ++axis)
    for (double sign : {-1.0, 1.0})
      rigid = cut(rigid, {sign < 0 ? box.low : box.high, sign * Vec<3>::Unit(axis)}, tolerance);
  return rigid;
}

} // namespace

std::optional<Rigid> mirrored(const Rigid& rigid, int axis) {
  if (const auto* plane = std::get_if<RigidPlane>(&rigid)) {
    const RigidPlane image{flipped(plane->point, axis), flipped(plane->normal, axis)};
    const double size = 1 + plane->point.norm();
    const bool parallel = plane->normal.cross(image.normal).norm() <= 1e-9 * plane->normal.squaredNorm();
    const bool one = std::abs(plane->normal.dot(image.point - plane->point)) <= 1e-9 * size * plane->normal.norm();
    return parallel && one ? std::nullopt : std::optional<Rigid>(image);
  }
  if (const auto* ball = std::get_if<RigidBall>(&rigid)) {
    const RigidBall image{flipped(ball->centre, axis), ball->radius};
    return same(image.centre, ball->centre, ball->radius) ? std::nullopt : std::optional<Rigid>(image);
  }
  if (const auto* cylinder = std::get_if<RigidCylinder>(&rigid)) {
    const RigidCylinder image{flipped(cylinder->point, axis), flipped(cylinder->axis, axis), cylinder->radius};
    const double length = cylinder->axis.norm();
    const Vec<3> apart = (image.point - cylinder->point).cross(cylinder->axis);
    const bool one = cylinder->axis.cross(image.axis).norm() <= 1e-9 * length * length &&
                     apart.norm() <= 1e-9 * cylinder->radius * length;
    return one ? std::nullopt : std::optional<Rigid>(image);
  }
  const auto& surface = std::get<RigidSurface>(rigid);
  Bounds box;
  box.take(surface.surface.points);
  if (std::abs(box.low[axis] + box.high[axis]) <= 1e-6 * box.size()) return std::nullopt; // spans the mirror alike
  RigidSurface image{mirrored(surface.surface, axis, 1), surface.rim};
  for (SurfaceLine& line : image.rim) line.points.row(axis) *= -1, line.normals.row(axis) *= -1;
  return image;
}

RigidSurface shown(const Rigid& rigid, const Bounds& box, const std::vector<Window>& windows) {
  RigidSurface surface = std::visit([&](const auto& one) { return whole(one, box, windows); }, rigid);
  const Points& points = surface.surface.points;
  if (points.cols() == 0) return {};
  Eigen::Index nearest = 0;
  (points.colwise() - box.centre()).colwise().squaredNorm().minCoeff(&nearest);
  const Vec<3> point = points.col(nearest), apart = (box.low - point).cwiseMax(point - box.high);
  if (apart.maxCoeff() > 0.5 * box.size()) return {};
  Bounds own, room = box;
  own.take(points);
  room.take(own.size() <= box.size() ? points : Points(point));
  const double air = 0.05 * box.size();
  room.low.array() -= air;
  room.high.array() += air;
  return within(std::move(surface), room);
}

} // namespace signorini::view
