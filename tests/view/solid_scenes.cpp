#include "solid_scenes.hpp"

#include <cmath>
#include <numbers>

namespace signorini::view {
namespace {

/// ∂x/∂u^d by central differences, one-sided at the cube's sides.
Vec<3> tangent(const SolidMap& map, const Vec<3>& at, int d) {
  const double step = 1e-5;
  Vec<3> up = at, down = at;
  up[d] = std::min(1.0, at[d] + step), down[d] = std::max(0.0, at[d] - step);
  return (map(up) - map(down)) / (up[d] - down[d]);
}

/// One side of the cube: `across` its direction, `end` 0 or 1.
struct Side {
  const SolidMap& map;
  int across, end;

  Vec<3> at(double u, double v) const {
    Vec<3> cube;
    cube[across] = end, cube[(across + 1) % 3] = u, cube[(across + 2) % 3] = v;
    return cube;
  }
  Vec<3> normal(const Vec<3>& cube) const {
    return (end == 1 ? 1 : -1) *
           tangent(map, cube, (across + 1) % 3).cross(tangent(map, cube, (across + 2) % 3)).normalized();
  }
  SurfaceLine line(Vec<2> from, Vec<2> to, int pieces, double spacing) const {
    SurfaceLine line{Points(3, pieces + 1), Points(3, pieces + 1), spacing};
    for (int i = 0; i <= pieces; ++i) {
      const Vec<2> uv = from + (to - from) * i / pieces;
      line.points.col(i) = map(at(uv[0], uv[1]));
      line.normals.col(i) = normal(at(uv[0], uv[1]));
    }
    return line;
  }
};

void add_side(Body& solid, const Side& side, const std::array<int, 3>& elements, int divisions) {
  const int columns = elements[(side.across + 1) % 3], rows = elements[(side.across + 2) % 3], nu = columns * divisions,
            nv = rows * divisions;
  Surface& skin = solid.skin;
  const Eigen::Index first = skin.points.cols(), triangles = skin.triangles.cols();
  skin.points.conservativeResize(3, first + (nu + 1) * (nv + 1));
  skin.normals.conservativeResize(3, skin.points.cols());
  skin.triangles.conservativeResize(3, triangles + 2 * nu * nv);
  for (int j = 0, t = 0; j <= nv; ++j)
    for (int i = 0; i <= nu; ++i) {
      const Vec<3> cube = side.at(double(i) / nu, double(j) / nv);
      const int a = static_cast<int>(first) + i + (nu + 1) * j, b = a + 1, c = b + nu + 1, d = a + nu + 1;
      skin.points.col(a) = side.map(cube);
      skin.normals.col(a) = side.normal(cube);
      if (i == nu || j == nv) continue;
      if (side.end == 1)
        skin.triangles.col(triangles + t++) << a, b, c, skin.triangles.col(triangles + t++) << a, c, d;
      else
        skin.triangles.col(triangles + t++) << a, c, b, skin.triangles.col(triangles + t++) << a, d, c;
    }
  for (int i = 0; i <= columns; ++i)
    (i % columns ? solid.mesh_lines : solid.rim)
        .push_back(side.line({double(i) / columns, 0}, {double(i) / columns, 1}, nv, i % columns ? 0.2 : 0));
  for (int j = 0; j <= rows; ++j)
    (j % rows ? solid.mesh_lines : solid.rim)
        .push_back(side.line({0, double(j) / rows}, {1, double(j) / rows}, nu, j % rows ? 0.2 : 0));
}

} // namespace

Body mapped_solid(const SolidMap& map, const std::array<int, 3>& elements, int divisions, const SpaceField& field) {
  Body solid;
  solid.skin.points.resize(3, 0), solid.skin.normals.resize(3, 0), solid.skin.triangles.resize(3, 0);
  for (int across = 0; across < 3; ++across)
    for (int end : {0, 1}) add_side(solid, {map, across, end}, elements, divisions);
  const auto values = [&](const Points& points) {
    VectorX result(field ? points.cols() : 0);
    for (Eigen::Index i = 0; i < result.size(); ++i) result[i] = field(points.col(i));
    return result;
  };
  solid.skin.values = values(solid.skin.points);
  const int n = divisions;
  for (int e = 0; e < elements[0] * elements[1] * elements[2]; ++e) {
    const Vec<3> first(e % elements[0], e / elements[0] % elements[1], e / elements[0] / elements[1]);
    Lattice lattice{n, Points(3, (n + 1) * (n + 1) * (n + 1)), {}};
    for (int p = 0; p < lattice.points.cols(); ++p) {
      const Vec<3> within = Vec<3>(p % (n + 1), p / (n + 1) % (n + 1), p / (n + 1) / (n + 1)) / n;
      lattice.points.col(p) = map((first + within).cwiseQuotient(Vec<3>(elements[0], elements[1], elements[2])));
    }
    lattice.values = values(lattice.points);
    solid.inside.push_back(std::move(lattice));
  }
  return solid;
}

SolidMap block_map(const Vec<3>& low, const Vec<3>& high) {
  return [=](const Vec<3>& cube) { return Vec<3>(low + cube.cwiseProduct(high - low)); };
}

SolidMap shell_map(double inner, double outer) {
  return [=](const Vec<3>& cube) {
    const double around = 0.5 * std::numbers::pi * cube[0], up = 0.45 * std::numbers::pi * cube[1];
    const double radius = inner + (outer - inner) * cube[2];
    return Vec<3>(radius * std::cos(up) * std::cos(around), radius * std::cos(up) * std::sin(around),
                  radius * std::sin(up));
  };
}

double area(const Surface& surface) {
  double sum = 0;
  for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) {
    const Vec<3> a = surface.points.col(surface.triangles(0, t));
    sum +=
        0.5 *
        (surface.points.col(surface.triangles(1, t)) - a).cross(surface.points.col(surface.triangles(2, t)) - a).norm();
  }
  return sum;
}

} // namespace signorini::view
