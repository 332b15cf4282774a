#pragma once
// Measures of tessellated surfaces and of lines on them.

#include "base/eigen.hpp"

namespace signorini::test {

/// The enclosed volume (∫ x·n dA / 3) of a surface; the triangles are oriented by the normals.
template <class Surface> double volume(const Surface& surface) {
  double sum = 0;
  for (const auto& t : surface.triangles.colwise()) {
    const Vec<3> a = surface.points.col(t[0]), b = surface.points.col(t[1]), c = surface.points.col(t[2]);
    const Vec<3> facing = 0.5 * (b - a).cross(c - a);
    sum += (a + b + c).dot(facing) / 9 * (facing.dot(surface.normals.col(t[0])) < 0 ? -1 : 1);
  }
  return sum;
}

/// The length of lines.
template <class Lines> double length(const Lines& lines) {
  double sum = 0;
  for (const auto& line : lines)
    for (Eigen::Index i = 1; i < line.points.cols(); ++i) sum += (line.points.col(i) - line.points.col(i - 1)).norm();
  return sum;
}

} // namespace signorini::test
