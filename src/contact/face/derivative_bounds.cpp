// Bounds on the derivatives of a face over an element.

#include "contact/face/bezier_element.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::contact {

template <int D> void DerivativeBounds<D>::include(const DerivativeBounds& other) {
  for (std::size_t a = 0; a < lower.size(); ++a) {
    lower[a] = lower[a].cwiseMin(other.lower[a]);
    upper[a] = upper[a].cwiseMax(other.upper[a]);
  }
  for (std::size_t k = 0; k < second.size(); ++k) second[k] = std::max(second[k], other.second[k]);
}

namespace {

/// Largest length of X and largest |W| in the combinations row(k) of the points k = i + nu j, i < ni, j < nj.
template <int D, bool Rational, class Combination>
std::array<double, 2> largest(int ni, int nj, int nu, const Combination& row) {
  double length2 = 0, weight = 0;
  for (int j = 0; j < nj; ++j)
    for (int i = 0; i < ni; ++i) {
      const auto here = row(i + nu * j);
      if constexpr (Rational) {
        length2 = std::max(length2, here.template head<D>().squaredNorm());
        weight = std::max(weight, std::abs(here(D)));
      } else {
        length2 = std::max(length2, here.squaredNorm());
      }
    }
  return {std::sqrt(length2), weight};
}

/// Bounds on the derivatives of X, and on those of W with respect to ξ.
template <int D> struct HomogeneousBounds {
  DerivativeBounds<D> position;
  std::array<double, D - 1> weight_slope{};
  std::array<double, FaceGeometry<D>::seconds> weight_second{};
};

template <int D, int W, bool Rational> HomogeneousBounds<D> homogeneous_bounds(const BezierElement<D>& element) {
  using Row = Eigen::Matrix<double, W, 1>;
  const int nu = element.degree[0] + 1, nv = D == 2 ? 1 : element.degree[D - 2] + 1;
  std::array<double, D - 1> lengths;
  for (std::size_t a = 0; a < D - 1; ++a) lengths[a] = element.interval[a][1] - element.interval[a][0];
  const auto point = [q = element.points](int k) { return Eigen::Map<const Row>(q + k * W); };
  HomogeneousBounds<D> bounds;
  for (std::size_t a = 0; a < D - 1; ++a) {
    const int step = a == 0 ? 1 : nu, p = (a == 0 ? nu : nv) - 1;
    Row lower = Row::Constant(std::numeric_limits<double>::infinity()), upper = -lower;
    for (int j = 0; j < (a == 0 ? nv : nv - 1); ++j)
      for (int i = 0; i < (a == 0 ? nu - 1 : nu); ++i) {
        const Row difference = point(i + nu * j + step) - point(i + nu * j);
        lower = lower.cwiseMin(difference);
        upper = upper.cwiseMax(difference);
      }
    const double scale = p / lengths[a];
    bounds.position.lower[a] = scale * lower.template head<D>();
    bounds.position.upper[a] = scale * upper.template head<D>();
    if constexpr (Rational) bounds.weight_slope[a] = scale * std::max(std::abs(lower(D)), std::abs(upper(D)));

    const auto [length, weight] =
        largest<D, Rational>(a == 0 ? nu - 2 : nu, a == 0 ? nv : nv - 2, nu,
                             [&](int k) -> Row { return point(k + 2 * step) - 2 * point(k + step) + point(k); });
    const double scale2 = p * (p - 1) / (lengths[a] * lengths[a]);
    const std::size_t own = a == 0 ? 0 : 2; // x_,aa
    bounds.position.second[own] = scale2 * length;
    bounds.weight_second[own] = scale2 * weight;
  }
  if constexpr (D == 3) {
    const auto [length, weight] = largest<D, Rational>(
        nu - 1, nv - 1, nu, [&](int k) -> Row { return point(k + nu + 1) - point(k + nu) - point(k + 1) + point(k); });
    const double scale = (nu - 1) * (nv - 1) / (lengths[0] * lengths[1]);
    bounds.position.second[1] = scale * length;
    bounds.weight_second[1] = scale * weight;
  }
  return bounds;
}

/// Bounds of a rational element, in coordinates with the origin c amid the points: x − c = X/W.
template <int D> DerivativeBounds<D> rational_bounds(BezierElement<D> element) {
  using Row = Eigen::Matrix<double, 4, 1>;
  const int points = element.count();
  const auto row = [&](int k) { return Eigen::Map<const Row>(element.points + 4 * k); };
  Vec<D> center = Vec<D>::Zero();
  for (int k = 0; k < points; ++k) center += row(k).template head<D>() / (row(k)(D) * points);
  double shifted[4 * most_face_functions<D>];
  double least = std::numeric_limits<double>::infinity(), most = 0,
         reach = 0; // of W; largest |x − c|
  for (int k = 0; k < points; ++k) {
    Eigen::Map<Row> to(shifted + 4 * k);
    to = row(k);
    to.template head<D>() -= to(D) * center;
    least = std::min(least, to(D));
    most = std::max(most, to(D));
    reach = std::max(reach, to.template head<D>().norm() / to(D));
  }
  element.points = shifted;
  auto [bounds, weight_slope, weight_second] = homogeneous_bounds<D, 4, true>(element);
  // x_,α = (X_,α − W_,α (x − c))/W,  x_,αβ = (X_,αβ − W_,α x_,β − W_,β x_,α − W_,αβ (x − c))/W
  std::array<double, D - 1> slope; // largest |x_,α|
  for (std::size_t a = 0; a < D - 1; ++a) {
    const Vec<D> slack = Vec<D>::Constant(weight_slope[a] * reach);
    const Vec<D> lower = bounds.lower[a] - slack, upper = bounds.upper[a] + slack;
    bounds.lower[a] = (lower / least).cwiseMin(lower / most);
    bounds.upper[a] = (upper / least).cwiseMax(upper / most);
    slope[a] = bounds.lower[a].cwiseAbs().cwiseMax(bounds.upper[a].cwiseAbs()).norm();
  }
  for (std::size_t k = 0; k < bounds.second.size(); ++k) {
    const std::size_t a = k == 2 ? 1 : 0, b = k == 0 ? 0 : D - 2;
    bounds.second[k] =
        (bounds.second[k] + weight_slope[a] * slope[b] + weight_slope[b] * slope[a] + weight_second[k] * reach) / least;
  }
  return bounds;
}

} // namespace

template <int D> DerivativeBounds<D> derivative_bounds(const BezierElement<D>& element) {
  if (!element.polynomial) return rational_bounds<D>(element);
  return homogeneous_bounds < D, D == 2 ? 2 : 4, false > (element).position;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template struct DerivativeBounds<D>;                                                                                 \
  template DerivativeBounds<D> derivative_bounds(const BezierElement<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
