#include "contact/face/normal_cone.hpp"

#include "contact/face/surface.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::contact {

namespace {

template <int D> double angle(const Vec<D>& one, const Vec<D>& other) {
  return 2 * std::atan2((one - other).norm(), (one + other).norm());
}

/// A cone around the vectors of a ball with this middle and radius.
template <int D> NormalCone<D> around(const Vec<D>& middle, double radius) {
  const double length = middle.norm();
  if (!(radius < length)) return {};
  return {middle / length, std::asin(radius / length)};
}

} // namespace

template <int D> NormalCone<D> normal_cone(const DerivativeBounds<D>& bounds, double orientation) {
  std::array<Vec<D>, D - 1> middle;
  double radius[D - 1];
  for (std::size_t a = 0; a < D - 1; ++a) {
    middle[a] = 0.5 * (bounds.lower[a] + bounds.upper[a]);
    radius[a] = 0.5 * (bounds.upper[a] - bounds.lower[a]).norm();
  }
  const Vec<D> normal = orientation * normal_of<D>(middle);
  if constexpr (D == 2)
    return around<2>(normal, radius[0]);
  else // |τ₁ × τ₂ − A₁ × A₂| ≤ r₁ |A₂| + |A₁| r₂ + r₁ r₂
    return around<3>(normal, radius[0] * middle[1].norm() + middle[0].norm() * radius[1] + radius[0] * radius[1]);
}

template <int D> NormalCone<D> joined(const NormalCone<D>& one, const NormalCone<D>& other) {
  const double between = angle<D>(one.axis, other.axis);
  const NormalCone<D>& wider = one.half >= other.half ? one : other;
  const NormalCone<D>& narrower = one.half >= other.half ? other : one;
  if (between + narrower.half <= wider.half) return wider;
  const double half = 0.5 * (one.half + other.half + between);
  if (half >= NormalCone<D>::pi || between >= 0.99 * NormalCone<D>::pi) return {};
  // From the axis of the wider cone towards the other by half − wider.half
  const double way = half - wider.half;
  const Vec<D> axis =
      (std::sin(between - way) * wider.axis + std::sin(way) * narrower.axis) / std::max(std::sin(between), 1e-300);
  return {axis.normalized(), half};
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template NormalCone<D> normal_cone(const DerivativeBounds<D>&, double);                                              \
  template NormalCone<D> joined(const NormalCone<D>&, const NormalCone<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
