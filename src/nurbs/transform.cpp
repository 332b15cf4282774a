#include "nurbs/transform.hpp"

#include "base/error.hpp"
#include "nurbs/constants.hpp"
#include "nurbs/directions.hpp"

#include <cmath>
#include <numbers>

namespace signorini::nurbs {

void check_point(const char* name, const Point& point, int dimension) {
  require(point.size() == dimension, "nurbs.transform.coordinates",
          {{"argument", name}, {"expected", dimension}, {"count", point.size()}});
  require(point.allFinite(), "nurbs.transform.finite", {{"argument", name}, {"point", point}});
}

Eigen::Vector2d direction_of(double degrees) {
  require(std::isfinite(degrees), "nurbs.transform.angle", {{"angle", degrees}});
  // Reduces the angle to ±45° and adds quarter turns, which are exact.
  const double quarters = std::round(degrees / 90), rest = (degrees - 90 * quarters) * std::numbers::pi / 180;
  Vec<2> direction(std::cos(rest), std::sin(rest));
  for (double turns = quarters - 4 * std::floor(quarters / 4); turns > 0; --turns)
    direction = Vec<2>(-direction(1), direction(0));
  return direction;
}

Mat<3> rotation(double angle, const Point& axis) {
  check_point("axis", axis, 3);
  require(axis.norm() > 0, "nurbs.transform.axis");
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
  homogeneous.topRows(linear.rows()) =
      linear.lazyProduct(patch.homogeneous().topRows(dimension)) + shift.lazyProduct(weights);
  homogeneous.bottomRows(1) = weights;
  return {patch.directions(), std::move(homogeneous)};
}

Patch translate(const Patch& patch, const Point& by) {
  check_point("by", by, patch.dimension());
  return transform(patch, MatrixX::Identity(patch.dimension(), patch.dimension()), by);
}

Patch rotate(const Patch& patch, double angle, const Point& center, const Point& axis) {
  check_point("center", center, patch.dimension());
  MatrixX linear;
  if (patch.dimension() == 3) {
    linear = rotation(angle, axis);
  } else {
    require(axis.size() == 0, "nurbs.transform.plane_axis");
    const Eigen::Vector2d turn = direction_of(angle);
    linear = (MatrixX(2, 2) << turn(0), -turn(1), turn(1), turn(0)).finished();
  }
  return transform(patch, linear, center - linear.lazyProduct(center));
}

Patch scale(const Patch& patch, const Point& factors, const Point& center) {
  check_point("factors", factors, patch.dimension());
  check_point("center", center, patch.dimension());
  for (double factor : factors)
    require(factor > 0, factor < 0 ? "nurbs.transform.negative_factor" : "nurbs.transform.zero_factor",
            {{"factor", factor}});
  return transform(patch, factors.asDiagonal(), center - factors.cwiseProduct(center));
}

Patch to_space(const Patch& patch, double z) {
  require(patch.dimension() == 2, "nurbs.to_space.dimension");
  require(std::isfinite(z), "nurbs.to_space.z", {{"z", z}});
  return transform(patch, MatrixX::Identity(3, 2), Vec<3>(0, 0, z));
}

Patch to_plane(const Patch& patch) {
  if (patch.dimension() == 2) return patch;
  require(patch.parametric_dimension() <= 2, "nurbs.to_plane.volume");
  const MatrixX points = patch.points();
  const double low = points.row(2).minCoeff(), high = points.row(2).maxCoeff();
  require(high - low <= rounding * points.cwiseAbs().maxCoeff(), "nurbs.to_plane.slanted",
          {{"low", low}, {"high", high}});
  return transform(patch, MatrixX::Identity(2, 3), Vec<2>(0, 0));
}

namespace {

/// The direction whose lines of control points extend farthest along the normal from end to end, summed over the lines.
int direction_along(const Patch& patch, const Point& normal) {
  const VectorX heights = patch.points().transpose().lazyProduct(normal);
  int best = 0;
  double most = 0;
  for (int d = 0; d < patch.parametric_dimension(); ++d) {
    const int count = patch.direction(d).functions(), stride = patch.stride(d);
    double extent = 0;
    for (int n = 0; n < patch.functions(); ++n)
      if (n / stride % count == 0) extent += std::abs(heights(n + stride * (count - 1)) - heights(n));
    extent *= count; // the mean over the lines, up to a factor common to all directions
    if (extent > (1 + same_place) * most) {
      best = d;
      most = extent;
    }
  }
  return best;
}

} // namespace

Patch mirror(const Patch& patch, const Point& point, const Point& normal) {
  check_point("point", point, patch.dimension());
  check_point("normal", normal, patch.dimension());
  require(normal.norm() > 0, "nurbs.mirror.normal");
  const VectorX n = normal.normalized();
  // x ↦ x − 2 n n·(x − p)
  const MatrixX linear = MatrixX::Identity(patch.dimension(), patch.dimension()) - 2 * n * n.transpose();
  const Patch image = transform(patch, linear, 2 * n * n.dot(point));
  return patch.parametric_dimension() < patch.dimension() - 1 ? image : reverse(image, direction_along(patch, n));
}

} // namespace signorini::nurbs
