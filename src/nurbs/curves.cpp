#include "nurbs/curves.hpp"

#include "base/error.hpp"
#include "nurbs/constants.hpp"

#include <cmath>

namespace signorini::nurbs {

Patch line(const Point& from, const Point& to) {
  check_point("from", from, from.size() == 3 ? 3 : 2);
  check_point("to", to, static_cast<int>(from.size()));
  require(from != to, "nurbs.line.point", {{"point", from}});
  MatrixX points(from.size(), 2);
  points << from, to;
  return make_patch({KnotVector::single(1)}, points);
}

Patch arc(const Point& center, double radius, double start, double stop) {
  check_point("center", center, center.size() == 3 ? 3 : 2);
  require(radius > 0 && std::isfinite(radius), "nurbs.arc.radius", {{"radius", radius}});
  require(std::isfinite(start) && std::isfinite(stop), "nurbs.arc.angles", {{"start", start}, {"stop", stop}});
  const double turn = stop - start;
  require(turn != 0, "nurbs.arc.empty", {{"angle", start}});
  // Tolerance for computed angles: 90·(1 + ε) is one quarter.
  require(std::abs(turn) <= 360 * (1 + rounding), "nurbs.arc.turn", {{"start", start}, {"stop", stop}});
  const int segments = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / 90 - rounding)));

  // The middle control point of a segment is the intersection of the end tangents at r/cos(θ/2), with weight cos(θ/2),
  // θ being the segment's angle (NURBS Book, 7.3).
  const double weight = direction_of(turn / segments / 2)(0);
  std::vector<double> knots(3, 0.0);
  MatrixX homogeneous = MatrixX::Ones(center.size() + 1, 2 * segments + 1);
  for (int i = 0; i <= 2 * segments; ++i) {
    const bool corner = i % 2 == 1;
    const double angle = start + turn * i / (2 * segments);
    const double w = corner ? weight : 1;
    homogeneous.col(i).head(center.size()) = w * center;
    homogeneous.col(i).head(2) += radius * direction_of(angle);
    homogeneous(center.size(), i) = w;
    if (!corner && i > 0) knots.insert(knots.end(), 2, i / (2.0 * segments));
  }
  knots.push_back(1);
  return {{KnotVector(2, std::move(knots))}, std::move(homogeneous)};
}

Patch circle(const Point& center, double radius) {
  return arc(center, radius, 0, 360);
}

} // namespace signorini::nurbs
