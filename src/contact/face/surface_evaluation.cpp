// The current shape of a face: Bézier points, boxes, and evaluation at points.

#include "contact/face/surface.hpp"
#include "nurbs/bezier.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::contact {

namespace {

constexpr int face_row = nurbs::max_degree + 1;

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

} // namespace

/// Calls run<P>(), P the degree in every direction if the code is specialized for it, otherwise 0.
template <int D> template <class Run> void Surface<D>::with_degree(int element, const Run& run) const {
  if (const int p = degree(element, 0); p == degree(element, D - 2)) switch (p) {
    case 1:
      return run.template operator()<1>();
    case 2:
      return run.template operator()<2>();
    case 3:
      return run.template operator()<3>();
    case 4:
      return run.template operator()<4>();
    case 5:
      return run.template operator()<5>();
    case 6:
      return run.template operator()<6>();
    }
  run.template operator()<0>();
}

/// Calls run<W>(), W the number of values per Bézier point.
template <int D> template <class Run> void Surface<D>::with_width(const Run& run) const {
  if (D == 2 && polynomial_)
    run.template operator()<2>();
  else
    run.template operator()<4>();
}

template <int D> double Surface<D>::move(const double* displacement) {
  for (int i = 0; i < functions(); ++i)
    for (int k = 0; k < D; ++k) points_(k, i) = reference_(k, i) + displacement[D * body_function(i) + k];
  double distance = 0;
  with_width([&]<int W>() { distance = update_bezier<W>(); });
  return distance;
}

template <int D> template <int W> double Surface<D>::moved2(const double* before, const double* now) const {
  using Point = Eigen::Map<const Vec<D>>;
  double change2 = (Point(now) - Point(before)).squaredNorm();
  if constexpr (W == 4)
    if (!polynomial_) change2 /= now[D] * now[D]; // weights do not change
  return change2;
}

template <int D> double Surface<D>::moved_since(const Surface& before) const {
  double largest2 = 0;
  with_width([&]<int W>() {
    for (std::size_t q = 0; q < bezier_.size(); q += W)
      largest2 = std::max(largest2, moved2<W>(&before.bezier_[q], &bezier_[q]));
  });
  return std::sqrt(largest2);
}

/// Q_kl = Σ_ab C(a, k) C(b, l) w_ab (x_ab, 1), one direction after the other. Returns the largest change of an x.
template <int D> template <int W> double Surface<D>::update_bezier() {
  using Row = Eigen::Matrix<double, W, 1>;
  using Rows = Eigen::Matrix<double, W, Eigen::Dynamic>;
  Rows homogeneous = Rows::Zero(W, functions());
  if (polynomial_) {
    homogeneous.template topRows<D>() = points_;
  } else {
    homogeneous.template topRows<D>() = points_ * weights_.asDiagonal();
    homogeneous.row(W == 4 ? D : 0) = weights_.transpose();
  }
  double largest2 = 0;
  const auto set = [&](double* q, const Row& row) {
    largest2 = std::max(largest2, moved2<W>(q, row.data()));
    std::copy_n(row.data(), W, q);
  };
  for (const Element& element : elements_) {
    const int* local = nodes_.data() + element.nodes;
    const auto c = direction(0).extraction(element.index[0]);
    const int nu = static_cast<int>(c.cols()), mu = static_cast<int>(c.rows()), mv = element.functions / mu;
    double* q = bezier_.data() + element.bezier;
    Row along[face_row * (D == 2 ? 1 : face_row)]; // of every row of functions
    for (int b = 0; b < mv; ++b)
      for (int k = 0; k < nu; ++k) {
        Row sum = Row::Zero();
        for (int a = 0; a < mu; ++a) sum += c(a, k) * homogeneous.col(local[b * mu + a]);
        if constexpr (D == 2)
          set(q + k * W, sum);
        else
          along[b * nu + k] = sum;
      }
    if constexpr (D == 3) {
      const auto d = direction(1).extraction(element.index[1]);
      for (int l = 0; l < d.cols(); ++l)
        for (int k = 0; k < nu; ++k, q += W) {
          Row sum = Row::Zero();
          for (int b = 0; b < mv; ++b) sum += d(b, l) * along[b * nu + k];
          set(q, sum);
        }
    }
  }
  return std::sqrt(largest2);
}

template <int D> void Surface<D>::bounds(int element, Vec<D>& lower, Vec<D>& upper) const {
  with_width([&]<int W>() { bounds_with<W>(element, lower, upper); });
}

template <int D> template <int W> void Surface<D>::bounds_with(int element, Vec<D>& lower, Vec<D>& upper) const {
  using Row = Eigen::Matrix<double, W, 1>;
  const double* q = bezier_.data() + elements_[element].bezier;
  const auto point = [&](int k) {
    const Eigen::Map<const Row> row(q + k * W);
    return polynomial_ ? Row(row) : Row(row / row(W == 4 ? D : 0));
  };
  Row least = point(0), most = least;
  for (int k = 1; k < elements_[element].points; ++k) {
    const Row x = point(k);
    least = least.cwiseMin(x);
    most = most.cwiseMax(x);
  }
  lower = least.template head<D>();
  upper = most.template head<D>();
}

template <int D> double Surface<D>::least_along(int element, const Vec<D>& direction) const {
  const int width = this->width();
  const double* q = bezier_.data() + elements_[element].bezier;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < elements_[element].points; ++k, q += width) {
    const double x = direction.dot(Eigen::Map<const Vec<D>>(q));
    least = std::min(least, polynomial_ ? x : x / q[D]);
  }
  return least;
}

/// P is the degree in every direction if it is known at compile time, otherwise 0.
template <int D>
template <int P, int Order>
void Surface<D>::bernsteins(int element, const FaceCoordinates<D>& xi, Bernsteins& out) const {
  for (int d = 0; d < D - 1; ++d) {
    const auto [a, b] = interval(element, d);
    if constexpr (P > 0)
      nurbs::bernstein<P, Order>((xi(d) - a) / (b - a), 1 / (b - a), out[d].data());
    else
      nurbs::bernstein(degree(element, d), (xi(d) - a) / (b - a), b - a, Order, out[d].data());
  }
}

template <int D>
void Surface<D>::locate(int element, const FaceCoordinates<D>& xi, int order, FaceGeometry<D>& point) const {
  with_degree(element, [&]<int P>() {
    with_width([&]<int W>() {
      if (order == 0) return locate_with<P, 0, W>(element, xi, point);
      if (order == 1) return locate_with<P, 1, W>(element, xi, point);
      locate_with<P, 2, W>(element, xi, point);
    });
  });
}

template <int D>
template <int P, int Order, int W>
void Surface<D>::locate_with(int element, const FaceCoordinates<D>& xi, FaceGeometry<D>& point) const {
  using Row = Eigen::Matrix<double, W, 1>;
  point.element = element;
  point.xi = xi;
  Bernsteins b;
  bernsteins<P, Order>(element, xi, b);
  const int nu = P > 0 ? P + 1 : degree(element, 0) + 1;
  const int nv = D == 2 ? 1 : P > 0 ? P + 1 : degree(element, D - 2) + 1;
  const double *u = b[0].data(), *v = b[D - 2].data(), *q = bezier_.data() + elements_[element].bezier;
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
  if (!polynomial_) {
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

template <int D> void Surface<D>::sample(int element, double* positions) const {
  with_degree(element, [&]<int P>() { sample_with<P>(element, positions); });
}

template <int D> template <int P> void Surface<D>::sample_with(int element, double* positions) const {
  const int width = this->width(), nu = degree(element, 0) + 1, nv = D == 2 ? 1 : degree(element, D - 2) + 1;
  const int gu = 3 * nu, gv = D == 2 ? 1 : 3 * nv, size = gu * gv;
  const double* q = bezier_.data() + elements_[element].bezier;
  if constexpr (P == 0) {
    FaceGeometry<D> point;
    const auto [from, to] = interval(element, 0);
    const auto [from_v, to_v] = interval(element, D - 2);
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
    for (int c = polynomial_ ? D - 1 : D; c >= 0; --c) {
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
      if (!polynomial_ && c < D)
        for (int k = 0; k < n * columns; ++k) out[k] /= weight[k];
    }
  }
}

/// w N_a and its first derivatives: value, then one direction after the other.
template <int D> template <int P> void Surface<D>::weighted_functions(FacePoint<D>& point, int order) const {
  const int* local = nodes(point.element);
  Bernsteins b;
  bernsteins<P, 1>(point.element, point.xi, b);
  double along[2][2 * face_row]; // N_a of one direction and their derivatives
  int count[2] = {1, 1};
  for (int d = 0; d < D - 1; ++d) {
    const auto extraction = direction(d).extraction(index(point.element, d));
    const double* c = extraction.data();
    const int n = count[d] = static_cast<int>(extraction.rows());
    const int points = P > 0 ? P + 1 : static_cast<int>(extraction.cols());
    // N_a = Σ_l C(a, l) B_l
    for (int k = 0; k <= order; ++k)
      for (int a = 0; a < n; ++a) {
        double sum = 0;
        for (int l = 0; l < points; ++l) sum += c[a * points + l] * b[d][k * points + l];
        along[d][k * n + a] = sum;
      }
  }
  const int nu = count[0], nv = D == 2 ? 1 : count[1];
  for (int j = 0, a = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i, ++a) {
      const double w = polynomial_ ? 1 : weights_(local[a]), v = D == 2 ? 1 : along[1][j];
      point.value[a] = w * along[0][i] * v;
      if (order == 0) continue;
      point.derivative[0][a] = w * along[0][nu + i] * v;
      if constexpr (D == 3) point.derivative[1][a] = w * along[0][i] * along[1][nv + j];
    }
}

template <int D> void Surface<D>::functions(FacePoint<D>& point, int order) const {
  with_degree(point.element, [&]<int P>() { weighted_functions<P>(point, order); });
  if (polynomial_) return;
  // R = wN/W,  R_,α = (w N_,α − R W_,α)/W
  const int n = functions_on(point.element);
  double total = 0;
  for (int a = 0; a < n; ++a) total += point.value[a];
  const double scale = 1 / total;
  for (int a = 0; a < n; ++a) point.value[a] *= scale;
  for (int d = 0; d < D - 1 && order > 0; ++d) {
    auto& derivative = point.derivative[d];
    double rate = 0;
    for (int a = 0; a < n; ++a) rate += derivative[a];
    for (int a = 0; a < n; ++a) derivative[a] = (derivative[a] - point.value[a] * rate) * scale;
  }
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template double Surface<D>::move(const double*);                                                                     \
  template double Surface<D>::moved_since(const Surface<D>&) const;                                                    \
  template void Surface<D>::bounds(int, Vec<D>&, Vec<D>&) const;                                                       \
  template double Surface<D>::least_along(int, const Vec<D>&) const;                                                   \
  template void Surface<D>::locate(int, const FaceCoordinates<D>&, int, FaceGeometry<D>&) const;                       \
  template void Surface<D>::sample(int, double*) const;                                                                \
  template void Surface<D>::functions(FacePoint<D>&, int) const;
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
