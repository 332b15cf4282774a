#include "tessellation/grid.hpp"

#include <algorithm>

namespace signorini::tessellation {

namespace {

/// Parameter at a fraction of an element's interval.
double parameter(const nurbs::KnotVector& knots, std::size_t e, double fraction) {
  const double from = knots.breaks()[e], to = knots.breaks()[e + 1];
  return from + (to - from) * fraction;
}

/// The parameters of an element (i, j) of a surface, or i of a curve.
VectorX parameters(const nurbs::Patch& patch, std::size_t i, std::size_t j, double s, double t) {
  VectorX xi(patch.parametric_dimension());
  xi(0) = parameter(patch.direction(0), i, s);
  if (xi.size() == 2) xi(1) = parameter(patch.direction(1), j, t);
  return xi;
}

std::vector<std::vector<double>> even(const nurbs::KnotVector& knots) {
  const int pieces = std::clamp(128 / knots.elements(), knots.degree() == 1 ? 1 : 2, 32);
  return std::vector(knots.elements(), even_cuts(pieces));
}

/// Fractions in both directions of a surface; a curve is a surface of one row.
Sampling<2> sampling_of(const nurbs::Patch& patch, const std::vector<Window>& windows) {
  const bool surface = patch.parametric_dimension() == 2;
  Sampling<2> all = {even(patch.direction(0)), surface ? even(patch.direction(1)) : Sampling<2>::value_type{{0.0}}};
  for (std::size_t j = 0; j < all[1].size() && !windows.empty(); ++j)
    for (std::size_t i = 0; i < all[0].size(); ++i) {
      const auto at_fractions = [&](double s, double t) { return place(patch, parameters(patch, i, j, s, t)); };
      const auto cuts = window_divisions(at_fractions, windows, false);
      add_divisions(all[0][i], cuts[0]);
      if (surface) add_divisions(all[1][j], cuts[1]);
    }
  return all;
}

/// Unit normal; zero in 2D and for curves. At a pole, where the derivatives do not span a plane, that of a nearby
/// point.
Vec<3> normal_at(const nurbs::Patch& patch, const VectorX& xi) {
  if (patch.dimension() == 2 || xi.size() == 1) return Vec<3>::Zero();
  const auto cross = [&](const VectorX& place) {
    const auto all = nurbs::derivatives(patch, place, 1);
    const Vec<3> first = all[1].value, second = all[2].value;
    const Vec<3> normal = first.cross(second);
    return normal.norm() > 1e-9 * (first.squaredNorm() + second.squaredNorm()) ? Vec<3>(normal.stableNormalized())
                                                                               : Vec<3>(Vec<3>::Zero());
  };
  const Vec<3> normal = cross(xi);
  if (normal.norm() > 0) return normal;
  VectorX nearby = xi;
  for (int d = 0; d < 2; ++d) {
    const double middle = 0.5 * (patch.direction(d).first() + patch.direction(d).last());
    nearby[d] += 1e-3 * (middle - xi[d]);
  }
  return cross(nearby);
}

} // namespace

Vec<3> place(const nurbs::Patch& patch, const VectorX& xi) {
  Vec<3> result = Vec<3>::Zero();
  result.head(patch.dimension()) = nurbs::evaluate(patch, xi);
  return result;
}

Skin tessellate(const nurbs::Patch& patch, double sign, const std::vector<Window>& windows) {
  const Sampling<2> sampling = sampling_of(patch, windows);
  const std::array<int, 2> counts = {static_cast<int>(sampling[0].size()), static_cast<int>(sampling[1].size())};
  using Index = std::array<int, 2>;
  const auto each = [&](const auto& visit) {
    for (int j = 0; j < counts[1]; ++j)
      for (int i = 0; i < counts[0]; ++i) visit(Index{i, j}, sampling[0][i], sampling[1][j]);
  };
  const auto point_at = [&](const Index& element, double s, double t) {
    const VectorX xi = parameters(patch, element[0], element[1], s, t);
    return SkinPoint{place(patch, xi), sign * normal_at(patch, xi)};
  };
  const auto add_lines = [&](Skin& skin, const Grid& grid, const Index& element) {
    add_borders(skin, grid, element, counts);
  };
  Skin skin = make_skin(true, false, each, point_at, add_lines);
  if (patch.parametric_dimension() == 1) skin.rim.resize(1), skin.mesh_lines.clear();
  return skin;
}

} // namespace signorini::tessellation
