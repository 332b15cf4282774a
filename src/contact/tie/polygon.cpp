#include "contact/tie/polygon.hpp"

#include <cmath>
#include <utility>

namespace signorini::contact {

namespace {

/// The part of a polygon where sign (x_d − bound) ≤ 0.
Polygon cut(const Polygon& polygon, int d, double bound, double sign) {
  Polygon inside;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec<2>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double before = sign * (a(d) - bound), after = sign * (b(d) - bound);
    if (before <= 0) inside.push_back(a);
    if ((before < 0 && after > 0) || (before > 0 && after < 0)) {
      inside.emplace_back(a + before / (before - after) * (b - a));
      inside.back()(d) = bound;
    }
  }
  return inside;
}

/// True if all corners are corners of the bounding box, up to rounding error.
bool is_box(const Polygon& polygon, const Vec<2>& lower, const Vec<2>& upper) {
  constexpr double rounding = 1e-12;
  if (polygon.size() != 4) return false;
  for (const Vec<2>& corner : polygon)
    for (int d = 0; d < 2; ++d)
      if (std::min(corner(d) - lower(d), upper(d) - corner(d)) > rounding * (upper(d) - lower(d))) return false;
  return std::abs(area(polygon) - (upper - lower).prod()) < rounding * area(polygon);
}

} // namespace

Polygon clip(const Polygon& polygon, const Vec<2>& lower, const Vec<2>& upper) {
  Polygon rest = polygon;
  for (int d = 0; d < 2; ++d) rest = cut(cut(rest, d, upper(d), 1), d, lower(d), -1);
  return rest;
}

double area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vec<2> a = polygon[i - 1] - polygon[0], b = polygon[i] - polygon[0];
    twice += a(0) * b(1) - a(1) * b(0);
  }
  return std::abs(twice) / 2;
}

solid::ElementQuadrature quadrature(const Polygon& polygon, int degree) {
  Vec<2> lower = polygon[0], upper = polygon[0];
  for (const Vec<2>& corner : polygon) {
    lower = lower.cwiseMin(corner);
    upper = upper.cwiseMax(corner);
  }
  if (is_box(polygon, lower, upper)) {
    const int n = degree / 2 + 1; // exact up to 2n − 1
    return solid::tensor_product(
        {solid::gauss_legendre(n, lower(0), upper(0)), solid::gauss_legendre(n, lower(1), upper(1))});
  }
  // Triangle a, b, c: x = a + s (b − a) + s t (c − b), dx = 2 A s ds dt; total degree 2 degree, with the factor s one
  // more
  const int n = degree + 1;
  const solid::QuadratureRule rule = solid::gauss_legendre(n, 0, 1);
  const auto triangles = static_cast<Eigen::Index>(polygon.size()) - 2;
  solid::ElementQuadrature result{MatrixX(2, triangles * n * n), VectorX(triangles * n * n)};
  Eigen::Index k = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vec<2>&a = polygon[0], &b = polygon[i - 1], &c = polygon[i];
    const double twice = 2 * area({a, b, c});
    for (std::size_t p = 0; p < rule.points.size(); ++p)
      for (std::size_t q = 0; q < rule.points.size(); ++q, ++k) {
        const double s = rule.points[p], t = rule.points[q];
        result.points.col(k) = a + s * (b - a) + s * t * (c - b);
        result.weights(k) = twice * s * rule.weights[p] * rule.weights[q];
      }
  }
  return result;
}

} // namespace signorini::contact
