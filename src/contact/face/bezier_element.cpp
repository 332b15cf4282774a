#include "contact/face/bezier_element.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::contact {

namespace {

/// B_k of degree P at the points of an even grid from border to border: the grid's points of B_0 first.
template <int P> const std::array<double, 3 * (P + 1) * (P + 1)>& grid_bernsteins() {
  static const auto table = [] {
    constexpr int n = 3 * (P + 1);
    std::array<double, n*(P + 1)> values;
    for (int i = 0; i < n; ++i) {
      double b[P + 1];
      nurbs::bernstein<P, 0>(static_cast<double>(i) / (n - 1), 1, b);
      for (int k = 0; k <= P; ++k) values[k * n + i] = b[k];
    }
    return values;
  }();
  return table;
}

/// W values, of which the first D are the position of Bézier point k.
template <int W, int D> Eigen::Matrix<double, W, 1> bezier_point(const BezierElement<D>& element, int k) {
  using Row = Eigen::Matrix<double, W, 1>;
  const Eigen::Map<const Row> row(element.points + k * W);
  return element.polynomial ? Row(row) : Row(row / row(W == 4 ? D : 0));
}

/// Bounding box of point(k), k from 0 to count − 1.
template <int D, class Point> void bounds_of(int count, const Point& point, Vec<D>& lower, Vec<D>& upper) {
  auto least = point(0), most = least;
  for (int k = 1; k < count; ++k) {
    const auto x = point(k);
    least = least.cwiseMin(x).eval();
    most = most.cwiseMax(x).eval();
  }
  lower = least.template head<D>();
  upper = most.template head<D>();
}

template <int P, int Order, int W, int D>
void locate_with(const BezierElement<D>& element, const FaceCoordinates<D>& xi, FaceGeometry<D>& point) {
  using Row = Eigen::Matrix<double, W, 1>;
  point.xi = xi;
  Bernsteins<D> b;
  bernsteins<P, Order>(element, xi, b);
  const int nu = P > 0 ? P + 1 : element.degree[0] + 1;
  const int nv = D == 2 ? 1 : P > 0 ? P + 1 : element.degree[D - 2] + 1;
  const double *u = b[0].data(), *v = b[D - 2].data(), *q = element.points;
  // (W x, W) and its derivatives in the order value; ,1 (,2); ,11 (,12 ,22)
  constexpr int count = D == 2 ? Order + 1 : (Order + 1) * (Order + 2) / 2;
  Row sums[count];
  for (Row& sum : sums) sum.setZero();
  for (int j = 0; j < nv; ++j) {
    Row along[Order + 1]; // ∂^k/∂ξ¹^k of the row
    for (Row& sum : along) sum.setZero();
    for (int a = 0; a < nu; ++a, q += W)
      for (int k = 0; k <= Order; ++k) along[k] += u[k * nu + a] * Eigen::Map<const Row>(q);
    if constexpr (D == 2) {
      for (int k = 0; k <= Order; ++k) sums[k] = along[k];
    } else {
      sums[0] += v[j] * along[0];
      if constexpr (Order > 0) {
        sums[1] += v[j] * along[1];
        sums[2] += v[nv + j] * along[0];
      }
      if constexpr (Order > 1) {
        sums[3] += v[j] * along[2];
        sums[4] += v[nv + j] * along[1];
        sums[5] += v[2 * nv + j] * along[0];
      }
    }
  }
  if (!element.polynomial) {
    // Quotient rule: W x = X; W x_,α = X_,α − W_,α x; W x_,αβ = X_,αβ − W_,α x_,β − W_,β x_,α − W_,αβ x. The last
    // component becomes that of 1, that is 1, 0, 0; its derivatives are needed first.
    constexpr int last = W == 4 ? D : 0;
    double rate[count];
    for (int d = 0; d < count; ++d) rate[d] = sums[d](last);
    const double scale = 1 / rate[0];
    sums[0] *= scale;
    if constexpr (Order > 0)
      for (int a = 0; a < D - 1; ++a) sums[1 + a] = scale * (sums[1 + a] - rate[1 + a] * sums[0]);
    if constexpr (Order > 1)
      for (int k = 0; k < FaceGeometry<D>::seconds; ++k) {
        const int alpha = k == 2 ? 1 : 0, beta = k == 0 ? 0 : 1;
        sums[D + k] = scale * (sums[D + k] - rate[1 + alpha] * sums[1 + beta] - rate[1 + beta] * sums[1 + alpha] -
                               rate[D + k] * sums[0]);
      }
  }
  point.position = sums[0].template head<D>();
  if constexpr (Order > 0)
    for (int a = 0; a < D - 1; ++a) point.tangent[a] = sums[1 + a].template head<D>();
  if constexpr (Order > 1)
    for (int k = 0; k < FaceGeometry<D>::seconds; ++k) point.second[k] = sums[D + k].template head<D>();
}

template <int P, int D> void sample_with(const BezierElement<D>& element, double* positions) {
  const int width = element.width(), nu = element.degree[0] + 1, nv = D == 2 ? 1 : element.degree[D - 2] + 1;
  const int gu = 3 * nu, gv = D == 2 ? 1 : 3 * nv, size = gu * gv;
  const double* q = element.points;
  if constexpr (P == 0) {
    FaceGeometry<D> point;
    const auto [from, to] = element.interval[0];
    const auto [from_v, to_v] = element.interval[D - 2];
    for (int k = 0; k < size; ++k) {
      FaceCoordinates<D> xi;
      if constexpr (D == 3) xi(1) = from_v + (to_v - from_v) * (k / gu) / (gv - 1);
      xi(0) = from + (to - from) * (k % gu) / (gu - 1);
      locate(element, xi, 0, point);
      for (int i = 0; i < D; ++i) positions[i * size + k] = point.position(i);
    }
  } else {
    constexpr int n = 3 * (P + 1), rows = D == 2 ? 1 : P + 1, columns = D == 2 ? 1 : n;
    const double* b = grid_bernsteins<P>().data();
    double weight[n * columns];
    // W x = Σ B_a(ξ¹) B_b(ξ²) Q_ab, the weight first
    for (int c = element.polynomial ? D - 1 : D; c >= 0; --c) {
      double along[rows * n];
      for (int l = 0; l < rows; ++l)
        for (int i = 0; i < n; ++i) {
          double sum = 0;
          for (int a = 0; a <= P; ++a) sum += b[a * n + i] * q[(l * (P + 1) + a) * width + c];
          along[l * n + i] = sum;
        }
      double* out = c == D ? weight : positions + c * size;
      if constexpr (D == 2) {
        std::copy_n(along, n, out);
      } else {
        for (int j = 0; j < n; ++j)
          for (int i = 0; i < n; ++i) {
            double sum = 0;
            for (int l = 0; l < rows; ++l) sum += b[l * n + j] * along[l * n + i];
            out[j * n + i] = sum;
          }
      }
      if (!element.polynomial && c < D)
        for (int k = 0; k < n * columns; ++k) out[k] /= weight[k];
    }
  }
}

} // namespace

template <int D> void bounds(const BezierElement<D>& element, Vec<D>& lower, Vec<D>& upper) {
  with_width<D>(element.polynomial, [&]<int W>() {
    bounds_of(
        element.count(), [&](int k) { return bezier_point<W>(element, k); }, lower, upper);
  });
}

template <int D>
void bounds_of_motion(const BezierElement<D>& before, const BezierElement<D>& now, Vec<D>& lower, Vec<D>& upper) {
  with_width<D>(now.polynomial, [&]<int W>() {
    using Row = Eigen::Matrix<double, W, 1>;
    bounds_of(
        now.count(), [&](int k) { return Row(bezier_point<W>(now, k) - bezier_point<W>(before, k)); }, lower, upper);
  });
}

template <int D> double least_along(const BezierElement<D>& element, const Vec<D>& direction) {
  const double* q = element.points;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < element.count(); ++k, q += element.width()) {
    const double x = direction.dot(Eigen::Map<const Vec<D>>(q));
    least = std::min(least, element.polynomial ? x : x / q[D]);
  }
  return least;
}

template <int D>
void locate(const BezierElement<D>& element, const FaceCoordinates<D>& xi, int order, FaceGeometry<D>& point) {
  with_degree(element, [&]<int P>() {
    with_width<D>(element.polynomial, [&]<int W>() {
      if (order == 0) return locate_with<P, 0, W>(element, xi, point);
      if (order == 1) return locate_with<P, 1, W>(element, xi, point);
      locate_with<P, 2, W>(element, xi, point);
    });
  });
}

template <int D> void sample(const BezierElement<D>& element, double* positions) {
  with_degree(element, [&]<int P>() { sample_with<P>(element, positions); });
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template void bounds(const BezierElement<D>&, Vec<D>&, Vec<D>&);                                                     \
  template void bounds_of_motion(const BezierElement<D>&, const BezierElement<D>&, Vec<D>&, Vec<D>&);                  \
  template double least_along(const BezierElement<D>&, const Vec<D>&);                                                 \
  template void locate(const BezierElement<D>&, const FaceCoordinates<D>&, int, FaceGeometry<D>&);                     \
  template void sample(const BezierElement<D>&, double*);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
