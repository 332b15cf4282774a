#include "nurbs/transform.hpp"

#include "base/error.hpp"

#include <cmath>
#include <numbers>

namespace signorini::nurbs {

void check_point(const char* name, const Point& point, int dimension) {
  require(point.size() == dimension, name, ": ", dimension, " coordinates are needed, got ", point.size());
  require(point.allFinite(), name, ": every coordinate must be a finite number, got (", point.transpose(), ")");
}

Eigen::Vector2d direction_of(double degrees) {
  require(std::isfinite(degrees), "angle: it is ", degrees, ", expected a finite number of degrees");
  // cos and sin of the rest within ±45°, then turned by whole quarters.
  const double quarters = std::round(degrees / 90), rest = (degrees - 90 * quarters) * std::numbers::pi / 180;
  const double c = std::cos(rest), s = std::sin(rest);
  switch (static_cast<int>(quarters - 4 * std::floor(quarters / 4))) {
  case 0:
    return {c, s};
  case 1:
    return {-s, c};
  case 2:
    return {-c, -s};
  default:
    return {s, -c};
  }
}

Mat<3> rotation(double angle, const Point& axis) {
  check_point("axis", axis, 3);
  require(axis.norm() > 0, "axis: it has no length; give the direction of the axis");
  const Vec<3> a = axis.normalized();
  const Eigen::Vector2d turn = direction_of(angle);
  Mat<3> cross;
  cross << 0, -a(2), a(1), a(2), 0, -a(0), -a(1), a(0), 0;
  // Rodrigues: R = cos θ (I − a aᵀ) + sin θ [a]× + a aᵀ
  return turn(0) * (Mat<3>::Identity() - a * a.transpose()) + turn(1) * cross + a * a.transpose();
}

Patch transform(const Patch& patch, const MatrixX& linear, const VectorX& shift) {
  const int dimension = patch.dimension();
  MatrixX homogeneous(linear.rows() + 1, patch.functions());
  const auto weights = patch.homogeneous().row(dimension);
  homogeneous.topRows(linear.rows()) = linear * patch.homogeneous().topRows(dimension) + shift * weights;
  homogeneous.bottomRows(1) = weights;
  return {patch.directions(), std::move(homogeneous)};
}

Patch translate(const Patch& patch, const Point& by) {
  check_point("by", by, patch.dimension());
  return transform(patch, MatrixX::Identity(patch.dimension(), patch.dimension()), by);
}

Patch rotate(const Patch& patch, double angle, const Point& centre, const Point& axis) {
  check_point("centre", centre, patch.dimension());
  MatrixX linear;
  if (patch.dimension() == 3) {
    linear = rotation(angle, axis);
  } else {
    require(axis.size() == 0, "axis: a plane patch turns about its centre; leave the axis out");
    const Eigen::Vector2d turn = direction_of(angle);
    linear = (MatrixX(2, 2) << turn(0), -turn(1), turn(1), turn(0)).finished();
  }
  return transform(patch, linear, centre - linear * centre);
}

Patch scale(const Patch& patch, const Point& factors, const Point& centre) {
  check_point("factors", factors, patch.dimension());
  check_point("centre", centre, patch.dimension());
  for (double factor : factors)
    require(factor > 0, "factors: ", factor, " is not positive; a mirrored patch would turn inside out");
  return transform(patch, factors.asDiagonal(), centre - factors.cwiseProduct(centre));
}

} // namespace signorini::nurbs
