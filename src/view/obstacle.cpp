#include "view/obstacle.hpp"

#include "view/cut.hpp"
#include "view/surface_lines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace signorini::view {
namespace {

constexpr Rgb rim_color = {95, 95, 95}, band_color = {200, 200, 200};
constexpr double small_extent = 280; // pixels of a picture of 1600 × 1000

/// Moves the end away from its neighbor until it lies outside the box.
void extend(Vec2& end, const Vec2& neighbor, const Box& box) {
  const double length = distance(neighbor, end);
  if (length == 0) return;
  const Vec2 corner = {box[0], box[2]}, opposite = {box[1], box[3]};
  const double factor = (distance(end, corner) + 2 * distance(corner, opposite)) / length;
  end = end + factor * (end - neighbor);
}

/// Strokes at 45° to the line, on its left, `spacing` pixels apart.
void hatch(Drawing& drawing, const std::vector<Vec2>& line, const Box& box, const Style& style) {
  const double spacing = 14 * style.unit, length = 18 * style.unit;
  double next = 0.5 * spacing; // distance to the next stroke
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double size = distance(line[i - 1], line[i]);
    if (size == 0) continue;
    const Vec2 t = 1 / size * (line[i] - line[i - 1]);
    while (next < size) {
      const Vec2 from = line[i - 1] + next * t, to = from + std::sqrt(0.5) * length * (t + left_of(t));
      for (auto& part : clip_line({from, to}, box))
        drawing.marks.push_back(Stroke{std::move(part), rim_color, 1.8 * style.unit});
      next += spacing;
    }
    next -= size;
  }
}

/// A gray band left of the line, for small obstacles, on which hatching is hard to read.
void shade(Drawing& drawing, const std::vector<Vec2>& line, double width) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 &a = line[i - 1], &b = line[i];
    const double size = distance(a, b);
    if (size == 0) continue;
    const Vec2 inwards = width / size * left_of(b - a);
    drawing.marks.push_back(Fill{{a, b, b + inwards, a + inwards}, band_color});
  }
}

/// The longer side of the bounding box of a line.
double extent_of(const std::vector<Vec2>& line) {
  double extent = 0;
  for (std::size_t axis : {0, 1}) {
    const auto [low, high] =
        std::minmax_element(line.begin(), line.end(), [&](const Vec2& a, const Vec2& b) { return a[axis] < b[axis]; });
    extent = std::max(extent, (*high)[axis] - (*low)[axis]);
  }
  return extent;
}

Vec<3> flipped(Vec<3> v, int axis) {
  v[axis] = -v[axis];
  return v;
}

bool same(const Vec<3>& a, const Vec<3>& b, double size) {
  return (a - b).norm() <= 1e-9 * size;
}

/// Even pieces in two directions, refined in windows.
template <class Place>
std::array<std::vector<double>, 2> fractions(std::array<int, 2> pieces, const std::vector<Window>& windows,
                                             const Place& place) {
  std::array<std::vector<double>, 2> result = {even_cuts(pieces[0]), even_cuts(pieces[1])};
  for (int j = 0; j < pieces[1] && !windows.empty(); ++j)
    for (int i = 0; i < pieces[0]; ++i) {
      const auto at_piece = [&](double s, double t) { return place((i + s) / pieces[0], (j + t) / pieces[1]).first; };
      const auto cuts = window_divisions(at_piece, windows, false);
      for (double cut : cuts[0]) result[0].push_back((i + cut) / pieces[0]);
      for (double cut : cuts[1]) result[1].push_back((j + cut) / pieces[1]);
    }
  for (std::vector<double>& all : result) add_divisions(all, {});
  return result;
}

/// Two unit vectors normal to a unit vector.
std::array<Vec<3>, 2> across(const Vec<3>& direction) {
  const Vec<3> first = direction.unitOrthogonal();
  return {first, direction.cross(first)};
}

/// A square of the plane, larger than the box; a vertex is the point nearest to the center of the box.
RigidSurface whole(const RigidPlane& plane, const Bounds& box, const std::vector<Window>&) {
  const Vec<3> normal = plane.normal.normalized(),
               foot = box.center() - normal.dot(box.center() - plane.point) * normal;
  const auto [a, b] = across(normal);
  const double half = 3 * (box.high - box.low).norm();
  const Surface square = tessellated({2, 2}, {}, [&, a = a, b = b](double u, double v) {
    return SurfacePlace{foot + half * ((2 * u - 1) * a + (2 * v - 1) * b), normal};
  });
  return {square, {}};
}

RigidSurface whole(const RigidBall& ball, const Bounds&, const std::vector<Window>& windows) {
  const Surface sphere = tessellated({96, 48}, windows, [&](double u, double v) {
    const double length = 2 * std::numbers::pi * u, height = std::numbers::pi * (v - 0.5);
    const Vec<3> out{std::cos(height) * std::cos(length), std::cos(height) * std::sin(length), std::sin(height)};
    return SurfacePlace{ball.center + ball.radius * out, out};
  });
  return {sphere, {}};
}

/// A cylinder of the length of the box along its axis, with a margin.
RigidSurface whole(const RigidCylinder& cylinder, const Bounds& box, const std::vector<Window>& windows) {
  const Vec<3> axis = cylinder.axis.normalized(),
               middle = cylinder.point + axis.dot(box.center() - cylinder.point) * axis;
  const double half = 0.5 * axis.cwiseAbs().dot(box.high - box.low) + 0.05 * box.size();
  const auto [a, b] = across(axis);
  RigidSurface result;
  const auto place = [&, a = a, b = b](double u, double v) {
    const double angle = 2 * std::numbers::pi * u;
    const Vec<3> out = std::cos(angle) * a + std::sin(angle) * b;
    return SurfacePlace{middle + (2 * v - 1) * half * axis + cylinder.radius * out, out};
  };
  constexpr int pieces = 128;
  result.surface = tessellated({pieces, 2}, windows, place);
  for (int end : {0, 1}) {
    const std::vector<double> way = fractions({pieces, 2}, windows, place)[0];
    const int count = std::ssize(way);
    SurfaceLine circle{Points(3, count), Points(3, count)};
    for (int i = 0; i < count; ++i) {
      const auto [point, normal] = place(way[i], end);
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

/// The part within the box, with a rim along cuts.
RigidSurface within(RigidSurface rigid, const Bounds& box) {
  const double tolerance = 1e-9 * box.size();
  for (int axis = 0; axis < 3; ++axis)
    for (double sign : {-1.0, 1.0})
      rigid = cut(rigid, {sign < 0 ? box.low : box.high, sign * Vec<3>::Unit(axis)}, tolerance);
  return rigid;
}

} // namespace

Outline half_plane(const Vec<2>& point, const Vec<2>& normal) {
  Outline outline;
  outline.endless = true;
  // −n is left of t = (−n_y, n_x)
  const Vec<2> along = Vec<2>(-normal[1], normal[0]);
  outline.line.setZero(3, 2);
  outline.line.col(0).head<2>() = point;
  outline.line.col(1).head<2>() = point + along;
  return outline;
}

Outline circle(const Vec<2>& center, double radius, const std::vector<Window>& windows) {
  const auto place = [&](double fraction) {
    const double angle = 2 * std::numbers::pi * fraction;
    return Vec<3>(center[0] + radius * std::cos(angle), center[1] + radius * std::sin(angle), 0);
  };
  return outline(place, 180, windows);
}

Outline outline(const std::function<Vec<3>(double)>& place, int pieces, const std::vector<Window>& windows) {
  std::vector<double> fractions = even_cuts(pieces);
  for (int k = 0; k < pieces && !windows.empty(); ++k) {
    const auto piece = [&](double s, double) { return place((k + s) / pieces); };
    const auto cuts = window_divisions(piece, windows, false);
    for (double cut : cuts[0]) fractions.push_back((k + cut) / pieces);
  }
  add_divisions(fractions, {});
  Outline outline{Points(3, static_cast<Eigen::Index>(fractions.size()))};
  for (Eigen::Index i = 0; i < outline.line.cols(); ++i) outline.line.col(i) = place(fractions[static_cast<int>(i)]);
  return outline;
}

Surface tessellated(const std::array<int, 2>& pieces, const std::vector<Window>& windows,
                    const std::function<SurfacePlace(double, double)>& place) {
  Surface surface;
  const auto [us, vs] = fractions(pieces, windows, place);
  const int columns = std::ssize(us) - 1, rows = std::ssize(vs) - 1, side = columns + 1, count = side * (rows + 1),
            triangles = 2 * columns * rows;
  surface.points.resize(3, count);
  surface.normals.resize(3, surface.points.cols());
  surface.triangles.resize(3, triangles);
  for (int j = 0, triangle = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const auto [point, normal] = place(us[i], vs[j]);
      const int here = i + side * j;
      surface.points.col(here) = point;
      surface.normals.col(here) = normal;
      if (i == columns || j == rows) continue;
      surface.triangles.col(triangle++) << here, here + 1, here + side + 1;
      surface.triangles.col(triangle++) << here, here + side + 1, here + side;
    }
  return surface;
}

Outline mirrored(const Outline& outline, int axis) {
  Outline image = outline;
  image.line = outline.line.rowwise().reverse(); // keeps the left side
  image.line.row(axis) *= -1;
  if (image.spoke.size() > 0) image.spoke.row(axis) *= -1;
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
    drawing.marks.push_back(Stroke{std::move(part), rim_color, 3.6 * style.unit});
  }
  if (outline.spoke.size() > 0)
    for (auto& part : clip_line(flat(outline.spoke), box))
      drawing.marks.push_back(Stroke{std::move(part), rim_color, 3.6 * style.unit});
}

Points worth_showing(const Outline& outline, const Bounds& box) {
  const Vec<2> size = (box.high - box.low).head<2>(), center = box.center().head<2>();
  const auto& line = outline.line;
  if (line.cols() < 2) return {};
  if (!outline.endless) {
    const Vec<3> extent = line.rowwise().maxCoeff() - line.rowwise().minCoeff();
    if (extent.maxCoeff() <= size.maxCoeff()) return line;
    return {};
  }
  // Closest-point projection of the center of the box onto the straight line through the ends
  const Vec<2> start = line.col(0).head<2>(), along = (line.col(line.cols() - 1).head<2>() - start).normalized();
  Points foot = Points::Zero(3, 1);
  foot.col(0).head<2>() = start + along.dot(center - start) * along;
  const Vec<2> away = (foot.col(0).head<2>() - center).cwiseAbs() - 0.5 * size;
  if (away.maxCoeff() <= 0.5 * size.maxCoeff()) return foot;
  return {};
}

std::optional<Rigid> mirrored(const Rigid& rigid, int axis) {
  if (const auto* plane = std::get_if<RigidPlane>(&rigid)) {
    const RigidPlane image{flipped(plane->point, axis), flipped(plane->normal, axis)};
    const double size = 1 + plane->point.norm();
    const bool parallel = plane->normal.cross(image.normal).norm() <= 1e-9 * plane->normal.squaredNorm();
    const bool one = std::abs(plane->normal.dot(image.point - plane->point)) <= 1e-9 * size * plane->normal.norm();
    return parallel && one ? std::nullopt : std::optional<Rigid>(image);
  }
  if (const auto* ball = std::get_if<RigidBall>(&rigid)) {
    const RigidBall image{flipped(ball->center, axis), ball->radius};
    return same(image.center, ball->center, ball->radius) ? std::nullopt : std::optional<Rigid>(image);
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
  if (std::abs(box.low[axis] + box.high[axis]) <= 1e-6 * box.size())
    return std::nullopt; // symmetric about the mirror plane
  RigidSurface image{mirrored(surface.surface, axis, 1), surface.rim};
  for (SurfaceLine& line : image.rim) line.points.row(axis) *= -1, line.normals.row(axis) *= -1;
  return image;
}

RigidSurface shown(const Rigid& rigid, const Bounds& box, const std::vector<Window>& windows) {
  RigidSurface surface = std::visit([&](const auto& one) { return whole(one, box, windows); }, rigid);
  const Points& points = surface.surface.points;
  if (points.cols() == 0) return {};
  Eigen::Index nearest = 0;
  (points.colwise() - box.center()).colwise().squaredNorm().minCoeff(&nearest);
  const Vec<3> point = points.col(nearest), apart = (box.low - point).cwiseMax(point - box.high);
  if (apart.maxCoeff() > 0.5 * box.size()) return {};
  Bounds own, region = box;
  own.take(points);
  region.take(own.size() <= box.size() ? points : Points(point));
  const double margin = 0.05 * box.size();
  region.low.array() -= margin;
  region.high.array() += margin;
  return within(std::move(surface), region);
}

} // namespace signorini::view
