#include "view/solid.hpp"

#include "view/cut.hpp"

#include <algorithm>
#include <utility>

namespace signorini::view {
namespace {

void mirror(Points& points, int axis) {
  points.row(axis) *= -1;
}

void mirror(std::vector<SurfaceLine>& lines, int axis) {
  for (SurfaceLine& line : lines) mirror(line.points, axis), mirror(line.normals, axis);
}

/// Half of the lines are closer together; without any, all lines get their full width.
double typical_spacing(const std::vector<SurfaceLine>& lines) {
  std::vector<double> all;
  all.reserve(lines.size());
  for (const SurfaceLine& line : lines) all.push_back(line.spacing);
  if (all.empty()) return 0;
  std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
  return all[all.size() / 2];
}

} // namespace

void Bounds::take(const Points& points) {
  if (points.cols() == 0) return;
  low = low.cwiseMin(points.rowwise().minCoeff());
  high = high.cwiseMax(points.rowwise().maxCoeff());
}

Bounds bounds(const Solid& solid) {
  Bounds box;
  for (const Points* points : {&solid.skin.points, &solid.control_points, &solid.undeformed.points}) box.take(*points);
  return box;
}

Surface mirrored(const Surface& surface, int axis, double sign) {
  Surface image = surface;
  for (Points* points : {&image.points, &image.normals, &image.vectors}) mirror(*points, axis);
  image.values *= sign;
  return image;
}

Solid mirrored(const Solid& solid, int axis, double sign) {
  Solid image = solid;
  image.skin = mirrored(solid.skin, axis, sign);
  image.undeformed = mirrored(solid.undeformed, axis, 1);
  mirror(image.mesh_lines, axis);
  mirror(image.rim, axis);
  mirror(image.undeformed_rim, axis);
  mirror(image.control_points, axis);
  for (Lattice& lattice : image.inside) mirror(lattice.points, axis), lattice.values *= sign;
  return image;
}

void join_at_mirror(Solid& solid, int axis) {
  if (const auto beyond = crossed_mirror(solid.skin.points, axis)) {
    const std::vector<Lattice> inside = std::exchange(solid.inside, {}); // the image closes the cut
    solid = cut(solid, *beyond);
    solid.inside = inside;
  }
  const double tolerance = 1e-9 * bounds(solid).size();
  const auto within = [&](const Points& points) { return points.row(axis).cwiseAbs().maxCoeff() <= tolerance; };
  const auto faces_mirror = [&](const SurfaceLine& line) {
    return within(line.points) && line.normals.row(axis).cwiseAbs().minCoeff() > 1 - 1e-6;
  };
  std::erase_if(solid.mesh_lines, faces_mirror);
  std::erase_if(solid.rim, faces_mirror);
  std::erase_if(solid.undeformed_rim, [&](const SurfaceLine& line) { return within(line.points); });
  const auto joined = std::stable_partition(solid.rim.begin(), solid.rim.end(),
                                            [&](const SurfaceLine& line) { return !within(line.points); });
  const double spacing = typical_spacing(solid.mesh_lines);
  for (auto line = joined; line != solid.rim.end(); ++line) {
    line->spacing = spacing;
    solid.mesh_lines.push_back(std::move(*line));
  }
  solid.rim.erase(joined, solid.rim.end());

  Triangles& triangles = solid.skin.triangles;
  std::vector<Eigen::Index> kept;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    if (!within(solid.skin.points(Eigen::all, triangles.col(t)))) kept.push_back(t);
  triangles = Triangles(triangles(Eigen::all, kept));
}

} // namespace signorini::view
