#include "bind/sampled_patch.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// Parameters of a direction, as many in each element.
struct Places {
  int pieces; ///< per element
  std::vector<double> xi;

  int count() const { return static_cast<int>(xi.size()); }
  int elements() const { return (count() - 1) / pieces; }
};

Places places(const nurbs::KnotVector& knots) {
  Places result{std::clamp(128 / knots.elements(), knots.degree() == 1 ? 1 : 2, 32), {knots.first()}};
  for (int e = 0; e < knots.elements(); ++e) {
    const double from = knots.breaks()[at(e)], to = knots.breaks()[at(e) + 1];
    for (int k = 1; k <= result.pieces; ++k) result.xi.push_back(from + (to - from) * k / result.pieces);
  }
  return result;
}

Vec<3> in_space(const VectorX& point) {
  Vec<3> result = Vec<3>::Zero();
  result.head(point.size()) = point;
  return result;
}

/// Nothing in the plane. At a pole, where the derivatives do not span a plane, the normal of a point beside it.
Vec<3> normal_at(const nurbs::Patch& surface, const Vec<2>& xi) {
  if (surface.dimension() == 2) return Vec<3>::Zero();
  const auto cross = [&](const Vec<2>& place) {
    const auto all = nurbs::derivatives(surface, place, 1);
    const Vec<3> first = all[1].value, second = all[2].value;
    const Vec<3> normal = first.cross(second);
    return normal.norm() > 1e-9 * (first.squaredNorm() + second.squaredNorm()) ? Vec<3>(normal.stableNormalized())
                                                                               : Vec<3>(Vec<3>::Zero());
  };
  const Vec<3> normal = cross(xi);
  if (normal.norm() > 0) return normal;
  Vec<2> beside = xi;
  for (int d = 0; d < 2; ++d) {
    const double middle = 0.5 * (surface.direction(d).first() + surface.direction(d).last());
    beside[d] += 1e-3 * (middle - xi[d]);
  }
  return cross(beside);
}

/// Points of a surface by their two counts.
struct Grid {
  const view::Surface& surface;
  std::array<Places, 2> places;

  int operator()(int i, int j) const { return i + places[0].count() * j; }

  /// All along a direction, the other one fixed.
  view::SurfaceLine line(int along, int fixed) const {
    const int count = places[at(along)].count();
    view::SurfaceLine result{view::Points(3, count), view::Points(3, count)};
    for (int k = 0; k < count; ++k) {
      const int point = along == 0 ? (*this)(k, fixed) : (*this)(fixed, k);
      result.points.col(k) = surface.points.col(point);
      result.normals.col(k) = surface.normals.col(point);
    }
    return result;
  }

  /// From the line to the nearer one of its neighbours, through the middle.
  double spacing(int along, int fixed) const {
    const Places& across = places[at(1 - along)];
    const int middle = places[at(along)].count() / 2;
    const auto point = [&](int k) { return surface.points.col(along == 0 ? (*this)(middle, k) : (*this)(k, middle)); };
    return std::min((point(fixed) - point(fixed - across.pieces)).norm(),
                    (point(fixed) - point(fixed + across.pieces)).norm());
  }
};

SampledPatch sampled_curve(const nurbs::Patch& curve) {
  const view::Points points = line_along(curve, VectorX::Zero(1), 0, 1);
  const view::Points none = view::Points::Zero(3, points.cols());
  return {{points, none, {}, {}}, {}, {{points, none}}};
}

} // namespace

Vec<3> place(const nurbs::Patch& patch, const VectorX& xi) {
  return in_space(nurbs::evaluate(patch, xi));
}

view::Points line_along(const nurbs::Patch& patch, VectorX xi, int direction, double fraction) {
  const Places all = places(patch.direction(direction));
  view::Points line(3, all.count());
  for (int k = 0; k < all.count(); ++k) {
    xi(direction) = all.xi[0] + fraction * (all.xi[at(k)] - all.xi[0]);
    line.col(k) = place(patch, xi);
  }
  return line;
}

SampledPatch sampled(const nurbs::Patch& patch, double sign) {
  if (patch.parametric_dimension() == 1) return sampled_curve(patch);
  SampledPatch result;
  view::Surface& surface = result.surface;
  const Grid grid{surface, {places(patch.direction(0)), places(patch.direction(1))}};
  const int columns = grid.places[0].count(), rows = grid.places[1].count();
  surface.points.resize(3, columns * rows);
  surface.normals.resize(3, columns * rows);
  surface.triangles.resize(3, 2 * (columns - 1) * (rows - 1));
  for (int j = 0, triangle = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int here = grid(i, j);
      const Vec<2> xi(grid.places[0].xi[at(i)], grid.places[1].xi[at(j)]);
      surface.points.col(here) = place(patch, xi);
      surface.normals.col(here) = sign * normal_at(patch, xi);
      if (i + 1 == columns || j + 1 == rows) continue;
      surface.triangles.col(triangle++) << here, here + 1, here + columns + 1;
      surface.triangles.col(triangle++) << here, here + columns + 1, here + columns;
    }
  for (int along : {0, 1}) {
    const Places& across = grid.places[at(1 - along)];
    for (int e = 0; e <= across.elements(); ++e) {
      view::SurfaceLine line = grid.line(along, e * across.pieces);
      const bool inner = e > 0 && e < across.elements();
      if (inner) line.spacing = grid.spacing(along, e * across.pieces);
      (inner ? result.mesh_lines : result.rim).push_back(std::move(line));
    }
  }
  return result;
}

} // namespace signorini::bind
