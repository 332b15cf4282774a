#include "contact/surface.hpp"

#include "base/index.hpp"
#include "nurbs/bezier.hpp"

#include <algorithm>
#include <numeric>

namespace signorini::contact {

namespace {

constexpr int row = nurbs::max_degree + 1;

/// Value and derivatives up to the second: how many there are.
template <int D> constexpr int derivatives = D == 2 ? 3 : 6;

/// 0, 1, … count − 1.
std::vector<int> numbers(int count) {
  std::vector<int> list(at(count));
  std::iota(list.begin(), list.end(), 0);
  return list;
}

/// Bézier extraction of an element that goes on from the end of a face along its tangent, by a part of the element
/// there, whose Bézier points at that end and next to it have the columns `end` and `next`:
///     Q_k = Q_end + k part (Q_end − Q_next).
MatrixX tangent_extraction(const VectorX& end, const VectorX& next, double part) {
  MatrixX extraction(end.size(), end.size());
  for (int k = 0; k < extraction.cols(); ++k) extraction.col(k) = end + k * part * (end - next);
  return extraction;
}

} // namespace

template <int D>
Surface<D>::Surface(const nurbs::Discretisation& body, nurbs::Side side)
    : Surface(body.face_patch(side), body.face_functions(side), nurbs::outward_sign(side)) {}

template <int D> Surface<D>::Surface(const nurbs::Patch& patch) : Surface(patch, numbers(patch.functions()), 1) {}

template <int D>
Surface<D>::Surface(const nurbs::Patch& patch, std::vector<int> functions, double orientation)
    : directions_(patch.directions()), functions_(std::move(functions)), weights_(patch.weights()),
      polynomial_((weights_.array() == weights_(0)).all()), orientation_(orientation), reference_(patch.points()),
      points_(reference_) {
  per_element_ = 1;
  for (std::size_t d = 0; d < directions_.size(); ++d) {
    per_element_ *= directions_[d].degree() + 1;
    ends_[d] = {directions_[d].first(), directions_[d].last()};
  }
  rows_ = polynomial_ ? D : D + 1;
  tabulate(directions_, 0);
}

/// Nodes and Bézier extraction of all elements, with the Bézier points in the reference configuration: functions over
/// `knots`, on the elements of directions_, which go on beyond open ends by `part`.
template <int D> void Surface<D>::tabulate(const std::vector<nurbs::KnotVector>& knots, double part) {
  // The element of the face itself whose functions live on e
  const auto own = [&](std::size_t d, int e) {
    return std::clamp(e - (beyond_[d][0] > 0 ? 1 : 0), 0, knots[d].elements() - 1);
  };
  const auto extraction = [&](std::size_t d, int e) {
    const MatrixX c = nurbs::bezier_extraction(knots[d], own(d, e));
    const double start = directions_[d].breaks()[at(e)];
    const Eigen::Index last = c.cols() - 1;
    if (start < ends_[d][0]) return MatrixX(tangent_extraction(c.col(0), c.col(1), part).rowwise().reverse());
    if (start >= ends_[d][1]) return tangent_extraction(c.col(last), c.col(last - 1), part);
    return c;
  };
  const nurbs::KnotVector &u = directions_.front(), &v = directions_.back();
  const int n = per_element_, nu = u.degree() + 1, elements = D == 2 ? u.elements() : u.elements() * v.elements();
  nodes_.clear();
  if constexpr (D == 3)
    for (std::size_t d = 0; d < 2; ++d) {
      spans_[d].clear();
      for (int e = 0; e < directions_[d].elements(); ++e) {
        const MatrixX c = extraction(d, e);
        for (int a = 0; a < c.rows(); ++a) spans_[d].insert(spans_[d].end(), c.row(a).begin(), c.row(a).end());
      }
    }
  bezier_.assign(at(elements * n * rows_), 0.0);
  extraction_.resize(at(elements * n * n));
  for (int e = 0; e < elements; ++e) {
    const int first_u = knots.front().first_function(own(0, e % u.elements()));
    const int first_v = D == 2 ? 0 : knots.back().first_function(own(D - 2, e / u.elements()));
    const MatrixX cu = extraction(0, e % u.elements());
    const MatrixX cv = D == 2 ? MatrixX::Ones(1, 1) : extraction(1, e / u.elements());
    double* c = extraction_.data() + e * n * n;
    for (int a = 0; a < n; ++a) {
      nodes_.push_back(first_u + a % nu + knots.front().functions() * (first_v + a / nu));
      for (int k = 0; k < n; ++k) c[a * n + k] = cu(a % nu, k % nu) * cv(a / nu, k / nu);
    }
    if (!polynomial_)
      for (int k = 0; k < n; ++k) {
        double& weight = bezier_[at((e * rows_ + D) * n + k)];
        for (int a = 0; a < n; ++a) weight += c[a * n + k] * weights_(nodes_[at(e * n + a)]);
      }
  }
  const int last = *std::max_element(functions_.begin(), functions_.end());
  move(std::vector<double>(at(D * (last + 1)), 0.0).data());
}

template <int D> std::array<bool, 2> Surface<D>::open_ends(int alpha) const {
  const int nu = directions_[0].functions(), nv = D == 2 ? 1 : directions_.back().functions();
  const int across = alpha == 0 ? nv : nu, step = alpha == 0 ? nu : 1, last = alpha == 0 ? nu - 1 : nu * (nv - 1);
  const double size = (reference_.rowwise().maxCoeff() - reference_.rowwise().minCoeff()).norm();
  const auto apart = [&](int i, int j) { return (reference_.col(i) - reference_.col(j)).norm() > 1e-10 * size; };
  bool seam = true;
  std::array<bool, 2> points{D == 3, D == 3}; // borders that are one point; the end of a curve always is
  for (int i = 0; i < across; ++i) {
    seam = seam && !apart(i * step, last + i * step);
    points[0] = points[0] && !apart(0, i * step);
    points[1] = points[1] && !apart(last, last + i * step);
  }
  return {!seam && !points[0], !seam && !points[1]};
}

template <int D> void Surface<D>::extend(double part) {
  const std::vector<nurbs::KnotVector> own = directions_;
  std::array<std::array<bool, 2>, D - 1> opens;
  for (int d = 0; d < D - 1; ++d) opens[at(d)] = open_ends(d);
  for (std::size_t d = 0; d < own.size(); ++d) {
    const auto& breaks = own[d].breaks();
    const auto& open = opens[d];
    if (open[0]) beyond_[d][0] = part * (breaks[1] - breaks[0]);
    if (open[1]) beyond_[d][1] = part * (breaks.back() - breaks[breaks.size() - 2]);
    std::vector<double> knots = own[d].knots();
    if (open[0]) {
      knots.insert(knots.begin() + own[d].degree(), knots.front());
      for (int i = 0; i <= own[d].degree(); ++i) knots[at(i)] -= beyond_[d][0];
    }
    if (open[1]) {
      knots.push_back(knots.back());
      for (int i = 0; i <= own[d].degree(); ++i) knots[knots.size() - 1 - at(i)] += beyond_[d][1];
    }
    directions_[d] = nurbs::KnotVector(own[d].degree(), std::move(knots));
  }
  tabulate(own, part);
  // Weights that fall steeply towards an end would become negative beyond it.
  for (int e = 0; e < elements() && !polynomial_; ++e)
    for (int k = 0; k < per_element_; ++k)
      if (bezier_[at((e * rows_ + D) * per_element_ + k)] <= 0) {
        directions_ = own;
        return extend(part / 2);
      }
}

template <int D> double Surface<D>::fade(const FaceCoordinates<D>& xi, FaceCoordinates<D>& rate) const {
  double product = 1;
  rate.setZero();
  for (int a = 0; a < D - 1; ++a) {
    const bool behind = xi(a) > ends_[at(a)][1];
    const double length = beyond_[at(a)][behind], out = behind ? xi(a) - ends_[at(a)][1] : ends_[at(a)][0] - xi(a);
    if (out <= 0 || length == 0) continue;
    // w = (1 − s)² (1 + 2s),  s the way out in parts of what was added
    const double s = std::min(out / length, 1.0), w = (1 - s) * (1 - s) * (1 + 2 * s);
    rate *= w;
    rate(a) = product * (behind ? -6 : 6) * s * (1 - s) / length;
    product *= w;
  }
  return product;
}

/// Bernstein polynomials of a curve's element: value, ,1, ,11 with per_element_ values each (N where the compiler
/// knows).
template <int D>
template <int N>
void Surface<D>::bernstein(int element, const FaceCoordinates<D>& xi, int order, double* out) const {
  const auto [a, b] = interval(element, 0);
  nurbs::bernstein<(N > 0 ? N - 1 : 0)>(degree(0), (xi(0) - a) / (b - a), b - a, order, out);
}

/// Bernstein polynomials of both directions of a surface: value, first, second derivative, `degree`+1 values each.
template <int D>
void Surface<D>::bernstein_pair(int element, const FaceCoordinates<D>& xi, int order, double* u, double* v) const {
  const auto [a, b] = interval(element, 0);
  const auto [c, d] = interval(element, 1);
  nurbs::bernstein(degree(0), (xi(0) - a) / (b - a), b - a, order, u);
  nurbs::bernstein(degree(1), (xi(1) - c) / (d - c), d - c, order, v);
}

template <int D> std::array<double, 2> Surface<D>::interval(int element, int alpha) const {
  const int count = directions_.front().elements();
  const std::size_t i = static_cast<std::size_t>(alpha == 0 ? element % count : element / count);
  const auto& breaks = direction(alpha).breaks();
  return {breaks[i], breaks[i + 1]};
}

template <int D> int Surface<D>::find_element(const FaceCoordinates<D>& xi) const {
  int element = 0;
  for (int a = D - 2; a >= 0; --a) element = element * direction(a).elements() + direction(a).find_element(xi(a));
  return element;
}

template <int D> int Surface<D>::neighbour(int element, int alpha, bool at_end) const {
  const int count = directions_.front().elements();
  const int index = alpha == 0 ? element % count : element / count;
  const int next = index + (at_end ? 1 : -1);
  if (next < 0 || next >= direction(alpha).elements()) return -1;
  return element + (next - index) * (alpha == 0 ? 1 : count);
}

template <int D> void Surface<D>::move(const double* displacement) {
  for (int i = 0; i < functions(); ++i)
    for (int k = 0; k < D; ++k) points_(k, i) = reference_(k, i) + displacement[D * body_function(i) + k];
  // Q_k = Σ_a C(a, k) w_a x_a
  const int n = per_element_;
  for (int e = 0; e < elements(); ++e) {
    const int* local = nodes(e);
    const double* c = extraction_.data() + e * n * n;
    double* q = bezier_.data() + e * n * rows_;
    std::fill_n(q, n * D, 0.0);
    for (int a = 0; a < n; ++a, c += n)
      for (int i = 0; i < D; ++i) {
        const double x = polynomial_ ? points_(i, local[a]) : weights_(local[a]) * points_(i, local[a]);
        for (int k = 0; k < n; ++k) q[i * n + k] += c[k] * x;
      }
  }
}

template <int D> void Surface<D>::bounds(int element, Vec<D>& lower, Vec<D>& upper) const {
  const int n = per_element_;
  const double* q = bezier_.data() + element * n * rows_;
  for (int i = 0; i < D; ++i) {
    lower(i) = upper(i) = polynomial_ ? q[i * n] : q[i * n] / q[D * n];
    for (int k = 1; k < n; ++k) {
      const double x = polynomial_ ? q[i * n + k] : q[i * n + k] / q[D * n + k];
      lower(i) = std::min(lower(i), x);
      upper(i) = std::max(upper(i), x);
    }
  }
}

/// Derivatives of W x and of W at a point of a surface, in the order value; ,1 ,2; ,11 ,12 ,22: first along ξ¹ for
/// every row of Bézier points, then across.
template <int D> void Surface<D>::sum_tensor(int element, const FaceCoordinates<D>& xi, int order, double* sums) const {
  double u[3 * row], v[3 * row];
  bernstein_pair(element, xi, order, u, v);
  const int nu = degree(0) + 1, nv = degree(1) + 1;
  const double* q = bezier_.data() + element * per_element_ * rows_;
  double along[3 * row]; // ∂^k/∂ξ¹^k of every row
  for (int i = 0; i < rows_; ++i, q += per_element_) {
    for (int k = 0; k <= order; ++k)
      for (int j = 0; j < nv; ++j) {
        double sum = 0;
        for (int a = 0; a < nu; ++a) sum += q[j * nu + a] * u[k * nu + a];
        along[k * nv + j] = sum;
      }
    constexpr int orders[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
    for (int d = 0, count = (order + 1) * (order + 2) / 2; d < count; ++d) {
      double sum = 0;
      for (int j = 0; j < nv; ++j) sum += along[orders[d][0] * nv + j] * v[orders[d][1] * nv + j];
      sums[d * (D + 1) + i] = sum;
    }
  }
}

template <int D>
template <int N>
void Surface<D>::locate_with(int element, const FaceCoordinates<D>& xi, int order, FacePoint<D>& point) const {
  point.element = element;
  point.xi = xi;
  // Derivatives of W x and of W, in the order value; ,1 (,2); ,11 (,12 ,22)
  double sums[(D + 1) * derivatives<D>] = {};
  if constexpr (D == 3) {
    sum_tensor(element, xi, order, sums);
  } else {
    double b[derivatives<D> * most_face_functions<D>];
    bernstein<N>(element, xi, order, b);
    const int n = N > 0 ? N : per_element_;
    const double* q = bezier_.data() + element * n * rows_;
    for (int d = 0; d <= order; ++d)
      for (int i = 0; i < rows_; ++i) {
        double sum = 0;
        for (int k = 0; k < n; ++k) sum += q[i * n + k] * b[d * n + k];
        sums[d * (D + 1) + i] = sum;
      }
  }
  const auto sum = [&](int d) { return Eigen::Map<const Vec<D>>(sums + d * (D + 1)); };
  if (polynomial_) {
    point.position = sum(0);
    for (int a = 0; a < D - 1 && order > 0; ++a) point.tangent[at(a)] = sum(1 + a);
    for (int k = 0; k < FacePoint<D>::seconds && order > 1; ++k) point.second[at(k)] = sum(D + k);
    return;
  }
  // Quotient rule: W x = X; W x_,α = X_,α − W_,α x; W x_,αβ = X_,αβ − W_,α x_,β − W_,β x_,α − W_,αβ x
  const auto weight = [&](int d) { return sums[d * (D + 1) + D]; };
  const double scale = 1 / weight(0);
  point.position = scale * sum(0);
  for (int a = 0; a < D - 1 && order > 0; ++a)
    point.tangent[at(a)] = scale * (sum(1 + a) - weight(1 + a) * point.position);
  for (int k = 0; k < FacePoint<D>::seconds && order > 1; ++k) {
    const int alpha = k == 2 ? 1 : 0, beta = k == 0 ? 0 : 1;
    point.second[at(k)] = scale * (sum(D + k) - weight(1 + alpha) * point.tangent[at(beta)] -
                                   weight(1 + beta) * point.tangent[at(alpha)] - weight(D + k) * point.position);
  }
}

template <int D>
void Surface<D>::locate(int element, const FaceCoordinates<D>& xi, int order, FacePoint<D>& point) const {
  if constexpr (D == 2) switch (per_element_) {
    case 2:
      return locate_with<2>(element, xi, order, point);
    case 3:
      return locate_with<3>(element, xi, order, point);
    case 4:
      return locate_with<4>(element, xi, order, point);
    case 5:
      return locate_with<5>(element, xi, order, point);
    case 6:
      return locate_with<6>(element, xi, order, point);
    case 7:
      return locate_with<7>(element, xi, order, point);
    }
  locate_with<0>(element, xi, order, point);
}

/// w N_a and its first derivatives: value, then one direction after the other.
template <int D> void Surface<D>::weighted_functions(FacePoint<D>& point, int order) const {
  const int* local = nodes(point.element);
  const auto weight = [&](int a) { return polynomial_ ? 1 : weights_(local[a]); };
  if constexpr (D == 2) {
    double b[2 * row];
    bernstein<0>(point.element, point.xi, order, b);
    const int n = per_element_;
    const double* c = extraction_.data() + point.element * n * n;
    for (int d = 0; d <= order; ++d)
      for (int a = 0; a < n; ++a) {
        // N_a = Σ_k C(a, k) B_k
        double sum = 0;
        for (int k = 0; k < n; ++k) sum += c[a * n + k] * b[d * n + k];
        (d == 0 ? point.value : point.derivative[0])[at(a)] = sum * weight(a);
      }
  } else {
    double bernsteins[2][3 * row], along[2][2 * row]; // N_a of one direction and their derivatives
    bernstein_pair(point.element, point.xi, order, bernsteins[0], bernsteins[1]);
    const int count = directions_.front().elements();
    const int index[2] = {point.element % count, point.element / count};
    for (int d = 0; d < 2; ++d) {
      const int n = degree(d) + 1;
      const double* c = spans_[at(d)].data() + index[d] * n * n;
      for (int k = 0; k <= order; ++k)
        for (int a = 0; a < n; ++a) {
          double sum = 0;
          for (int l = 0; l < n; ++l) sum += c[a * n + l] * bernsteins[d][k * n + l];
          along[d][k * n + a] = sum;
        }
    }
    const int nu = degree(0) + 1, nv = degree(1) + 1;
    const double *u = along[0], *v = along[1];
    for (int j = 0, a = 0; j < nv; ++j)
      for (int i = 0; i < nu; ++i, ++a) {
        const double w = weight(a);
        point.value[at(a)] = w * u[i] * v[j];
        if (order == 0) continue;
        point.derivative[0][at(a)] = w * u[nu + i] * v[j];
        point.derivative[1][at(a)] = w * u[i] * v[nv + j];
      }
  }
}

template <int D> void Surface<D>::functions(FacePoint<D>& point, int order) const {
  weighted_functions(point, order);
  if (polynomial_) return;
  // R = wN/W,  R_,α = (w N_,α − R W_,α)/W
  const int n = per_element_;
  double total = 0;
  for (int a = 0; a < n; ++a) total += point.value[at(a)];
  const double scale = 1 / total;
  for (int a = 0; a < n; ++a) point.value[at(a)] *= scale;
  for (int d = 0; d < D - 1 && order > 0; ++d) {
    auto& derivative = point.derivative[at(d)];
    double rate = 0;
    for (int a = 0; a < n; ++a) rate += derivative[at(a)];
    for (int a = 0; a < n; ++a) derivative[at(a)] = (derivative[at(a)] - point.value[at(a)] * rate) * scale;
  }
}

template <int D> Vec<D> Surface<D>::outward(const std::array<Vec<D>, D - 1>& tangent) const {
  if constexpr (D == 2)
    return orientation_ * Vec<2>(tangent[0](1), -tangent[0](0));
  else
    return orientation_ * tangent[0].cross(tangent[1]);
}

template class Surface<2>;
template class Surface<3>;

} // namespace signorini::contact
