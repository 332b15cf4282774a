#include "view/panel.hpp"

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

/// Median spacing of lines; without lines 0, for full width.
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

Bounds bounds(const Body& body) {
  Bounds box;
  for (const Points* points : {&body.skin.points, &body.control_points, &body.undeformed.points}) box.take(*points);
  for (const auto* lines : {&body.mesh_lines, &body.rim, &body.undeformed_rim})
    for (const SurfaceLine& line : *lines) box.take(line.points);
  return box;
}

Bounds bounds(const std::vector<Body>& bodies) {
  Bounds box;
  for (const Body& body : bodies) box.take(bounds(body));
  return box;
}

Surface mirrored(const Surface& surface, int axis, double sign) {
  Surface image = surface;
  for (Points* points : {&image.points, &image.normals, &image.vectors}) mirror(*points, axis);
  image.values *= sign;
  return image;
}

Body mirrored(const Body& body, int axis, double sign) {
  Body image = body;
  image.skin = mirrored(body.skin, axis, sign);
  image.undeformed = mirrored(body.undeformed, axis, 1);
  for (auto* lines : {&image.mesh_lines, &image.rim, &image.undeformed_rim}) mirror(*lines, axis);
  mirror(image.control_points, axis);
  for (Lattice& lattice : image.inside) mirror(lattice.points, axis), lattice.values *= sign;
  return image;
}

PointVector mirrored(PointVector vector, int axis) {
  vector.at[axis] *= -1, vector.vector[axis] *= -1;
  return vector;
}

void join_at_mirror(Body& body, int axis) {
  const bool solid = body.skin.normals.cols() > 0;
  if (const auto beyond = crossed_mirror(body.skin.points, axis)) {
    const std::vector<Lattice> inside = std::exchange(body.inside, {}); // the image closes the cut
    Body left = cut(body, *beyond);
    left.inside = inside;
    if (!solid) { // the image continues it at the cut
      left.rim = cut(body.rim, *beyond, 0);
      left.control_points = body.control_points;
      left.net_lines = body.net_lines;
    }
    body = std::move(left);
  }
  if (!solid) return;
  const double tolerance = 1e-9 * bounds(body).size();
  const auto within = [&](const Points& points) { return points.row(axis).cwiseAbs().maxCoeff() <= tolerance; };
  const auto faces_mirror = [&](const SurfaceLine& line) {
    return within(line.points) && line.normals.row(axis).cwiseAbs().minCoeff() > 1 - 1e-6;
  };
  std::erase_if(body.mesh_lines, faces_mirror);
  std::erase_if(body.rim, faces_mirror);
  std::erase_if(body.undeformed_rim, [&](const SurfaceLine& line) { return within(line.points); });
  const auto joined = std::stable_partition(body.rim.begin(), body.rim.end(),
                                            [&](const SurfaceLine& line) { return !within(line.points); });
  const double spacing = typical_spacing(body.mesh_lines);
  for (auto line = joined; line != body.rim.end(); ++line) {
    line->spacing = spacing;
    body.mesh_lines.push_back(std::move(*line));
  }
  body.rim.erase(joined, body.rim.end());

  Triangles& triangles = body.skin.triangles;
  std::vector<Eigen::Index> kept;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    if (!within(body.skin.points(Eigen::all, triangles.col(t)))) kept.push_back(t);
  triangles = Triangles(triangles(Eigen::all, kept));
}

} // namespace signorini::view
