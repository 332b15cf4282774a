#include "view/relief.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace signorini::view {
namespace {

void add_triangle(Ink& ink, const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, const Rgb& color) {
  ink.corners.insert(ink.corners.end(), {a, b, c});
  ink.colors.push_back(color);
}

/// The point of the surface at the offset (x, y) pixels from `point`: z = −(n_x x + n_y y)/n_z, if the surface is not
/// too steep.
Vec<3> on_surface(const Vec<3>& point, const Vec<3>& normal, double x, double y) {
  constexpr double steepest = 0.15;
  return point + Vec<3>(x, y, -(normal[0] * x + normal[1] * y) / std::max(std::abs(normal[2]), steepest));
}

/// A round end, or the joint of two pieces.
void add_joint(Ink& ink, const Vec<3>& point, const Vec<3>& normal, double radius, const Rgb& color) {
  const int corners = std::clamp(static_cast<int>(4 * std::sqrt(radius)) + 4, 6, 24);
  const auto corner = [&](int k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    return on_surface(point, normal, radius * std::cos(angle), radius * std::sin(angle));
  };
  for (int k = 0; k < corners; ++k) add_triangle(ink, point, corner(k), corner(k + 1), color);
}

} // namespace

void add_ribbon(Ink& ink, const Points& points, const Points& normals, const Pen& pen) {
  const double half = 0.5 * pen.width;
  for (Eigen::Index i = 1; i < points.cols(); ++i) {
    Vec<3> a = points.col(i - 1), b = points.col(i), na = normals.col(i - 1), nb = normals.col(i);
    if (pen.facing_only) {
      if (na[2] <= 0 && nb[2] <= 0) continue;
      // Up to where the surface faces away
      const double t = na[2] / (na[2] - nb[2]);
      if (na[2] < 0) a += t * (b - a), na += t * (nb - na);
      if (nb[2] < 0)
        b = points.col(i - 1) + t * (points.col(i) - points.col(i - 1)),
        nb = normals.col(i - 1) + t * (normals.col(i) - normals.col(i - 1));
    }
    for (auto [point, normal] : {std::pair{&a, &na}, std::pair{&b, &nb}}) {
      (*point)[2] += pen.lift;
      if (!pen.facing_only && (*normal)[2] < 0) *normal *= -1;
      add_joint(ink, *point, *normal, half, pen.color);
    }
    const Vec<2> along = (b - a).head<2>();
    if (along.norm() == 0) continue;
    const double x = -half * along[1] / along.norm(), y = half * along[0] / along.norm();
    const Vec<3> a1 = on_surface(a, na, x, y), a2 = on_surface(a, na, -x, -y), b1 = on_surface(b, nb, x, y),
                 b2 = on_surface(b, nb, -x, -y);
    add_triangle(ink, a1, a2, b2, pen.color);
    add_triangle(ink, a1, b2, b1, pen.color);
  }
}

void add_dot(Ink& ink, const Vec<3>& center, double radius, const Rgb& color) {
  add_joint(ink, center, Vec<3>::UnitZ(), radius, color);
}

} // namespace signorini::view
