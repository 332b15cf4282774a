#include "figure/obstacle_frame.hpp"

#include "view/obstacle.hpp"

#include <numbers>

namespace signorini::figure {

namespace {

/// A point of a level set at a part of the way between two of its points.
Vec<2> between(const contact::LevelSet<2>& level_set, const Vec<2>& a, const Vec<2>& b, double part) {
  contact::FacePoint<2> point;
  contact::find_closest(level_set, Vec<2>(a + part * (b - a)), point);
  contact::locate(level_set, point);
  return point.position;
}

view::Outline outline_of(const contact::LevelSet<2>& level_set, const std::vector<int>& chain,
                         const Motion<2>& motion) {
  constexpr int pieces = 4; // per segment of the mesh
  const auto& points = level_set.compiled->mesh.points;
  const int count = pieces * static_cast<int>(chain.size() - 1) + 1;
  view::Outline outline;
  outline.line.setZero(3, count);
  for (int i = 0; i < count; ++i) {
    const Vec<2> first = points.col(chain[i / pieces]);
    const int part = i % pieces;
    outline.line.col(i).head<2>() = motion * (part == 0 ? first
                                                        : between(level_set, first, points.col(chain[i / pieces + 1]),
                                                                  static_cast<double>(part) / pieces));
  }
  return outline;
}

} // namespace

view::Outline circle_of(const contact::Ball<2>& disc, const std::vector<Window>& windows) {
  view::Outline outline = view::circle(disc.center, disc.radius, windows);
  if (disc.hollow) outline.line = outline.line.rowwise().reverse().eval();
  return outline;
}

std::vector<view::Outline> outlines(const contact::LevelSet<2>& level_set, const Motion<2>& motion) {
  const contact::LevelMesh<2>& mesh = level_set.compiled->mesh;
  const auto count = static_cast<std::size_t>(mesh.points.cols());
  std::vector<int> next(count, -1), before(count, -1);
  for (const auto& [from, to] : mesh.simplices) next[from] = to, before[to] = from;
  std::vector<view::Outline> result;
  const auto follow = [&](int start) {
    std::vector<int> chain{start};
    for (int i = next[start]; i >= 0; i = next[i]) {
      chain.push_back(i);
      next[chain[chain.size() - 2]] = -1;
      if (i == start) break;
    }
    if (chain.size() > 1) result.push_back(outline_of(level_set, chain, motion));
  };
  for (int i = 0; i < static_cast<int>(count); ++i) // open ends first, then closed curves
    if (before[i] < 0) follow(i);
  for (int i = 0; i < static_cast<int>(count); ++i)
    if (next[i] >= 0) follow(i);
  return result;
}

view::RigidSurface surface_of(const contact::LevelSet<3>& level_set, const Motion<3>& motion) {
  const auto& [formula, low, high, tape, mesh, sorted] = *level_set.compiled;
  view::RigidSurface result;
  result.surface.points = motion * mesh.points;
  result.surface.normals.resize(3, mesh.points.cols());
  for (Eigen::Index i = 0; i < mesh.points.cols(); ++i)
    result.surface.normals.col(i) = motion.linear() * (*level_set.compiled)(mesh.points.col(i)).gradient.normalized();
  result.surface.triangles.resize(3, static_cast<Eigen::Index>(mesh.simplices.size()));
  for (std::size_t k = 0; k < mesh.simplices.size(); ++k)
    result.surface.triangles.col(static_cast<Eigen::Index>(k)) << mesh.simplices[k][0], mesh.simplices[k][1],
        mesh.simplices[k][2];
  return result;
}

view::RigidSurface surface_of(const contact::Torus& torus) {
  const auto place = [&](double u, double v) {
    contact::FacePoint<3> point;
    point.xi = 2 * std::numbers::pi * contact::FaceCoordinates<3>(u, v);
    contact::locate(torus, point);
    return view::SurfacePlace{point.position, contact::normal_of<3>(point.tangent).normalized()};
  };
  return {view::tessellated({96, 48}, {}, place), {}};
}

} // namespace signorini::figure
