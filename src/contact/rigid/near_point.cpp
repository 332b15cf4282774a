#include "contact/rigid/near_point.hpp"

namespace signorini::contact {

namespace {

/// |c|² − R²: products by fused multiplication, sums by two-sum (Ogita, Rump, Oishi), so that what cancels leaves no
/// error.
template <int D> double excess(const Vec<D>& center, double radius) {
  double sum = 0, rest = 0;
  const auto add = [&](double x, double y) {
    const double product = x * y, next = sum + product, added = next - sum;
    rest += std::fma(x, y, -product) + (sum - (next - added)) + (product - added);
    sum = next;
  };
  for (int i = 0; i < D; ++i) add(center(i), center(i));
  add(-radius, radius);
  return sum + rest;
}

} // namespace

template <int D> NearPoint<D> near_point(const Vec<D>& center, double radius, const Vec<D>& usual) {
  const double distance = center.norm(), more = excess<D>(center, radius);
  if (!(distance > radius / 2) || !std::isfinite(more)) return {center + radius * usual, usual};
  const Vec<D> normal = center / -distance;
  // c + R n = (|c| − R) c/|c|
  return {-more / (distance + radius) * normal, normal};
}

template NearPoint<2> near_point(const Vec<2>&, double, const Vec<2>&);
template NearPoint<3> near_point(const Vec<3>&, double, const Vec<3>&);

} // namespace signorini::contact
