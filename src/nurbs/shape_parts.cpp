#include "nurbs/shape_parts.hpp"

#include "base/error.hpp"

#include <cmath>

namespace signorini::nurbs {

void check_length(const char* name, double length) {
  require(length > 0 && std::isfinite(length), "nurbs.shapes.length", {{"argument", name}, {"length", length}});
}

void check_radii(double inner, double outer) {
  check_length("inner", inner);
  check_length("outer", outer);
  require(inner < outer, "nurbs.shapes.radii", {{"inner", inner}, {"outer", outer}});
}

void check_edge(const char* name, double length, const char* from, double start) {
  check_length(name, length);
  require(start + length > start, "nurbs.shapes.rounding",
          {{"argument", name}, {"length", length}, {"coordinate", from}, {"start", start}});
}

void check_radius(const char* name, double radius, const Point& center, int dimension) {
  check_length(name, radius);
  check_point("center", center, dimension);
  const char* const coordinates[] = {"center x", "center y", "center z"};
  for (int i = 0; i < dimension; ++i) check_edge(name, radius, coordinates[i], center(i));
}

Patch upright(const Patch& patch, const Point& shift) {
  return transform(patch, Eigen::Matrix<double, 3, 2>{{1, 0}, {0, 0}, {0, 1}}, shift);
}

} // namespace signorini::nurbs
