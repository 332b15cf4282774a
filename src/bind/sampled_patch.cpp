#include "bind/sampled_patch.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// Parameters of a direction.
struct Places {
  std::vector<double> xi;
  std::vector<int> borders; ///< of these, where elements begin, and the last one

  int count() const { return static_cast<int>(xi.size()); }
  int elements() const { return static_cast<int>(borders.size()) - 1; }
};

/// By element the fractions of its interval, from 0 to 1.
using Cuts = std::vector<std::vector<double>>;

/// As many in each element.
Cuts even(const nurbs::KnotVector& knots) {
  const int pieces = std::clamp(128 / knots.elements(), knots.degree() == 1 ? 1 : 2, 32);
  return Cuts(at(knots.elements()), even_cuts(pieces));
}

double parameter(const nurbs::KnotVector& knots, int e, double fraction) {
  const double from = knots.breaks()[at(e)], to = knots.breaks()[at(e) + 1];
  return from + (to - from) * fraction;
}

Places places(const nurbs::KnotVector& knots, const Cuts& cuts) {
  Places result{{knots.first()}, {0}};
  for (int e = 0; e < knots.elements(); ++e) {
    for (std::size_t k = 1; k < cuts[at(e)].size(); ++k) result.xi.push_back(parameter(knots, e, cuts[at(e)][k]));
    result.borders.push_back(result.count() - 1);
  }
  return result;
}

/// Of both directions of a surface, or of a curve and nothing.
std::array<Cuts, 2> cuts_of(const nurbs::Patch& patch, const std::vector<Window>& windows) {
  const bool surface = patch.parametric_dimension() == 2;
  std::array<Cuts, 2> all = {even(patch.direction(0)), surface ? even(patch.direction(1)) : Cuts(1)};
  for (std::size_t j = 0; j < all[1].size() && !windows.empty(); ++j)
    for (std::size_t i = 0; i < all[0].size(); ++i) {
      VectorX xi(surface ? 2 : 1);
      const auto at_fractions = [&](double s, double t) {
        xi(0) = parameter(patch.direction(0), static_cast<int>(i), s);
        if (surface) xi(1) = parameter(patch.direction(1), static_cast<int>(j), t);
        return place(patch, xi);
      };
      const auto cuts = window_cuts(at_fractions, windows, false);
      add_cuts(all[0][i], cuts[0]);
      add_cuts(all[1][j], cuts[1]);
    }
  return all;
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
  double spacing(int along, int border) const {
    const Places& across = places[at(1 - along)];
    const int middle = places[at(along)].count() / 2;
    const auto point = [&](int k) { return surface.points.col(along == 0 ? (*this)(middle, k) : (*this)(k, middle)); };
    const int own = across.borders[at(border)];
    return std::min((point(own) - point(across.borders[at(border - 1)])).norm(),
                    (point(own) - point(across.borders[at(border + 1)])).norm());
  }
};

SampledPatch sampled_curve(const nurbs::Patch& curve, const std::vector<Window>& windows) {
  const Places all = places(curve.direction(0), cuts_of(curve, windows)[0]);
  view::Points points(3, all.count());
  for (int k = 0; k < all.count(); ++k) points.col(k) = place(curve, VectorX::Constant(1, all.xi[at(k)]));
  const view::Points none = view::Points::Zero(3, points.cols());
  return {{points, none, {}, {}}, {}, {{points, none}}};
}

} // namespace

Vec<3> place(const nurbs::Patch& patch, const VectorX& xi) {
  return in_space(nurbs::evaluate(patch, xi));
}

view::Points line_along(const nurbs::Patch& patch, VectorX xi, int direction, double fraction) {
  const Places all = places(patch.direction(direction), even(patch.direction(direction)));
  view::Points line(3, all.count());
  for (int k = 0; k < all.count(); ++k) {
    xi(direction) = all.xi[0] + fraction * (all.xi[at(k)] - all.xi[0]);
    line.col(k) = place(patch, xi);
  }
  return line;
}

SampledPatch sampled(const nurbs::Patch& patch, double sign, const std::vector<Window>& windows) {
  if (patch.parametric_dimension() == 1) return sampled_curve(patch, windows);
  SampledPatch result;
  view::Surface& surface = result.surface;
  const auto cuts = cuts_of(patch, windows);
  const Grid grid{surface, {places(patch.direction(0), cuts[0]), places(patch.direction(1), cuts[1])}};
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
      view::SurfaceLine line = grid.line(along, across.borders[at(e)]);
      const bool inner = e > 0 && e < across.elements();
      if (inner) line.spacing = grid.spacing(along, e);
      (inner ? result.mesh_lines : result.rim).push_back(std::move(line));
    }
  }
  return result;
}

} // namespace signorini::bind
