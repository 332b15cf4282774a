#include "contact/surface.hpp"

#include "contact/constants.hpp"
#include "nurbs/bezier.hpp"

#include <algorithm>
#include <numeric>

namespace signorini::contact {

namespace {

constexpr int row = nurbs::max_degree + 1;

/// Number of values and derivatives up to the second.
template <int D> constexpr int derivatives = D == 2 ? 3 : 6;

/// 0, 1, … count − 1.
std::vector<int> numbers(int count) {
  std::vector<int> list(at(count));
  std::iota(list.begin(), list.end(), 0);
  return list;
}

/// A space extended along its tangent beyond its ends by elements of the given `lengths`, `part` of the last elements
/// (0: no extension). The Bézier points of a new element are
///     Q_k = Q_end + k part (Q_end − Q_next).
nurbs::Space1D extended(const nurbs::Space1D& space, double part, std::array<double, 2> lengths) {
  std::vector<double> breaks = space.breaks();
  std::vector<int> smoothness = space.smoothness();
  std::vector<nurbs::Element1D> elements;
  for (int e = 0; e < space.elements(); ++e) elements.push_back(space.element(e));
  for (const bool at_end : {false, true}) {
    if (lengths[at_end] == 0) continue;
    nurbs::Element1D beyond = at_end ? elements.back() : elements.front();
    const MatrixX c = at_end ? beyond.extraction : beyond.extraction.rowwise().reverse();
    const VectorX end = c.col(beyond.degree), out = end - c.col(beyond.degree - 1);
    for (int k = 0; k <= beyond.degree; ++k)
      beyond.extraction.col(at_end ? k : beyond.degree - k) = end + k * part * out;
    elements.insert(at_end ? elements.end() : elements.begin(), std::move(beyond));
    breaks.insert(at_end ? breaks.end() : breaks.begin(),
                  at_end ? breaks.back() + lengths[1] : breaks.front() - lengths[0]);
    // C¹ at the old end
    smoothness.insert(at_end ? smoothness.end() - 1 : smoothness.begin() + 1, 1);
  }
  return {std::move(breaks), std::move(smoothness), elements};
}

} // namespace

template <int D>
Surface<D>::Surface(const nurbs::Discretization& body, nurbs::Side side, int first)
    : Surface(body.face(side), body.face_functions(side), nurbs::outward_sign(side)) {
  for (int& function : functions_) function += first;
}

template <int D> Surface<D>::Surface(FaceGrid grid) : Surface(grid.row, std::move(grid.nodes), grid.orientation) {
  places_ = std::move(grid.places);
}

template <int D>
Surface<D>::Surface(const nurbs::Patch& patch) : Surface(nurbs::make_row(patch), numbers(patch.functions()), 1) {}

template <int D>
Surface<D>::Surface(const nurbs::Row& row, std::vector<int> functions, double orientation)
    : spaces_(row.directions()), functions_(std::move(functions)), weights_(row.weights()),
      polynomial_((weights_.array() == weights_(0)).all()), orientation_(orientation), reference_(row.points()),
      points_(reference_), rows_(polynomial_ ? D : D + 1) {
  for (std::size_t d = 0; d < spaces_.size(); ++d) ends_[d] = {spaces_[d].first(), spaces_[d].last()};
  tabulate();
}

/// Nodes and Bézier extraction of all elements, with the Bézier points in the reference configuration.
template <int D> void Surface<D>::tabulate() {
  const nurbs::Space1D &u = spaces_.front(), &v = spaces_.back();
  elements_.clear();
  nodes_.clear();
  extraction_.clear();
  bezier_.clear();
  for (int e = 0, count = D == 2 ? u.elements() : u.elements() * v.elements(); e < count; ++e) {
    Element element{{}, 1, 1, nodes_.size(), extraction_.size(), bezier_.size()};
    nurbs::ElementFunctions functions;
    std::array<MatrixX, 2> c{MatrixX::Ones(1, 1), MatrixX::Ones(1, 1)};
    for (std::size_t d = 0; d < D - 1; ++d) {
      element.index[d] = d == 0 ? e % u.elements() : e / u.elements();
      functions.along[d] = spaces_[d].functions_on(element.index[d]);
      functions.stride[d] = d == 0 ? 1 : u.functions();
      c[d] = spaces_[d].extraction(element.index[d]);
      element.functions *= static_cast<int>(c[d].rows());
      element.points *= static_cast<int>(c[d].cols());
    }
    bezier_.resize(element.bezier + at(rows_ * element.points), 0.0);
    double* weights = bezier_.data() + element.bezier + D * element.points;
    functions.each([&](int node, const std::array<int, 3>& i) {
      nodes_.push_back(node);
      for (int k = 0; k < element.points; ++k) {
        extraction_.push_back(c[0](i[0], k % c[0].cols()) * c[1](i[1], k / c[0].cols()));
        if (!polynomial_) weights[k] += extraction_.back() * weights_(node);
      }
    });
    most_functions_ = std::max(most_functions_, element.functions);
    elements_.push_back(element);
  }
  const int last = *std::max_element(functions_.begin(), functions_.end());
  move(std::vector<double>(at(D * (last + 1)), 0.0).data());
}

template <int D> std::array<bool, 2> Surface<D>::open_ends(int alpha) const {
  const int nu = spaces_[0].functions(), nv = D == 2 ? 1 : spaces_.back().functions();
  const int across = alpha == 0 ? nv : nu, step = alpha == 0 ? nu : 1, last = alpha == 0 ? nu - 1 : nu * (nv - 1);
  const double size = (reference_.rowwise().maxCoeff() - reference_.rowwise().minCoeff()).norm();
  const auto apart = [&](int i, int j) { return (reference_.col(i) - reference_.col(j)).norm() > same_place * size; };
  bool seam = true;
  std::array<bool, 2> points{D == 3, D == 3}; // whether a border is collapsed to one point; false for ends of curves
  for (int i = 0; i < across; ++i) {
    seam = seam && !apart(i * step, last + i * step);
    points[0] = points[0] && !apart(0, i * step);
    points[1] = points[1] && !apart(last, last + i * step);
  }
  return {!seam && !points[0], !seam && !points[1]};
}

template <int D> void Surface<D>::extend(double part) {
  const std::vector<nurbs::Space1D> own = spaces_;
  for (int a = 0; a < D - 1; ++a) {
    const auto [start, end] = open_ends(a);
    const auto length = [&](int element) {
      const auto [from, to] = own[at(a)].interval(element);
      return part * (to - from);
    };
    beyond_[at(a)] = {start ? length(0) : 0, end ? length(own[at(a)].elements() - 1) : 0};
    spaces_[at(a)] = extended(own[at(a)], part, beyond_[at(a)]);
  }
  tabulate();
  // Weights that decrease steeply towards an end become negative beyond it; then a shorter extension is tried.
  for (const Element& element : elements_)
    for (int k = 0; k < element.points && !polynomial_; ++k)
      if (bezier_[element.bezier + at(D * element.points + k)] <= 0) {
        spaces_ = own;
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
    // w = (1 − s)² (1 + 2s),  s the distance from the end relative to the extension
    const double s = std::min(out / length, 1.0), w = (1 - s) * (1 - s) * (1 + 2 * s);
    rate *= w;
    rate(a) = product * (behind ? -6 : 6) * s * (1 - s) / length;
    product *= w;
  }
  return product;
}

/// P is the degree in every direction if it is known at compile time, otherwise 0.
template <int D>
template <int P>
void Surface<D>::bernsteins(int element, const FaceCoordinates<D>& xi, int order, Bernsteins& out) const {
  for (int d = 0; d < D - 1; ++d) {
    const auto [a, b] = interval(element, d);
    nurbs::bernstein<P>(P > 0 ? P : degree(element, d), (xi(d) - a) / (b - a), b - a, order, out[at(d)].data());
  }
}

template <int D> int Surface<D>::find_element(const FaceCoordinates<D>& xi) const {
  int element = 0;
  for (int a = D - 2; a >= 0; --a) element = element * direction(a).elements() + direction(a).find_element(xi(a));
  return element;
}

template <int D> int Surface<D>::neighbor(int element, int alpha, bool at_end) const {
  const int next = index(element, alpha) + (at_end ? 1 : -1);
  if (next < 0 || next >= direction(alpha).elements()) return -1;
  return element + (at_end ? 1 : -1) * (alpha == 0 ? 1 : spaces_.front().elements());
}

template <int D> void Surface<D>::move(const double* displacement) {
  for (int i = 0; i < functions(); ++i)
    for (int k = 0; k < D; ++k) points_(k, i) = reference_(k, i) + displacement[D * body_function(i) + k];
  // Q_k = Σ_a C(a, k) w_a x_a
  for (const Element& element : elements_) {
    const int n = element.points;
    const int* local = nodes_.data() + element.nodes;
    const double* c = extraction_.data() + element.extraction;
    double* q = bezier_.data() + element.bezier;
    std::fill_n(q, n * D, 0.0);
    for (int a = 0; a < element.functions; ++a, c += n)
      for (int i = 0; i < D; ++i) {
        const double x = polynomial_ ? points_(i, local[a]) : weights_(local[a]) * points_(i, local[a]);
        for (int k = 0; k < n; ++k) q[i * n + k] += c[k] * x;
      }
  }
}

template <int D> void Surface<D>::bounds(int element, Vec<D>& lower, Vec<D>& upper) const {
  const int n = elements_[at(element)].points;
  const double* q = bezier_.data() + elements_[at(element)].bezier;
  for (int i = 0; i < D; ++i) {
    lower(i) = upper(i) = polynomial_ ? q[i * n] : q[i * n] / q[D * n];
    for (int k = 1; k < n; ++k) {
      const double x = polynomial_ ? q[i * n + k] : q[i * n + k] / q[D * n + k];
      lower(i) = std::min(lower(i), x);
      upper(i) = std::max(upper(i), x);
    }
  }
}

template <int D>
template <int P>
void Surface<D>::locate_with(int element, const FaceCoordinates<D>& xi, int order, FacePoint<D>& point) const {
  point.element = element;
  point.xi = xi;
  Bernsteins b;
  bernsteins<P>(element, xi, order, b);
  const int nu = P > 0 ? P + 1 : degree(element, 0) + 1;
  const int nv = D == 2 ? 1 : P > 0 ? P + 1 : degree(element, D - 2) + 1;
  const double *u = b[0].data(), *v = b[D - 2].data(), *q = bezier_.data() + elements_[at(element)].bezier;
  // Derivatives of W x and of W, in the order value; ,1 (,2); ,11 (,12 ,22): first in ξ¹ for every row of Bézier
  // points, then in ξ²
  constexpr int orders[2][6][2] = {{{0, 0}, {1, 0}, {2, 0}}, {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};
  const int count = D == 2 ? order + 1 : (order + 1) * (order + 2) / 2;
  double sums[(D + 1) * derivatives<D>] = {};
  double along[3 * (D == 2 ? 1 : row)]; // ∂^k/∂ξ¹^k of every row
  for (int i = 0; i < rows_; ++i, q += nu * nv) {
    for (int k = 0; k <= order; ++k)
      for (int j = 0; j < nv; ++j) {
        double sum = 0;
        for (int a = 0; a < nu; ++a) sum += q[j * nu + a] * u[k * nu + a];
        along[k * nv + j] = sum;
      }
    for (int d = 0; d < count; ++d) {
      const auto& [first, second] = orders[D - 2][d];
      double sum = 0;
      for (int j = 0; j < nv; ++j) sum += D == 2 ? along[first] : along[first * nv + j] * v[second * nv + j];
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

template <int D> double Surface<D>::least_along(int element, const Vec<D>& direction) const {
  const int n = elements_[at(element)].points;
  const double* q = bezier_.data() + elements_[at(element)].bezier;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < n; ++k) {
    double x = 0;
    for (int i = 0; i < D; ++i) x += direction(i) * q[i * n + k];
    least = std::min(least, polynomial_ ? x : x / q[D * n + k]);
  }
  return least;
}

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

template <int D>
void Surface<D>::locate(int element, const FaceCoordinates<D>& xi, int order, FacePoint<D>& point) const {
  with_degree(element, [&]<int P>() { locate_with<P>(element, xi, order, point); });
}

template <int D> void Surface<D>::sample(int element, const std::array<int, D - 1>& counts, double* positions) const {
  constexpr int most = nurbs::max_degree + 1;
  using Values = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, grid_points, most>;
  std::array<Values, 2> b; // of each direction, a row per point of the grid
  b[1].setOnes(1, 1);
  for (int d = 0; d < D - 1; ++d) {
    const int p = degree(element, d), n = counts[at(d)];
    b[at(d)].resize(n, p + 1);
    double values[most];
    for (int i = 0; i < n; ++i) {
      nurbs::bernstein<0>(p, static_cast<double>(i) / (n - 1), 1, 0, values);
      b[at(d)].row(i) = Eigen::Map<const Eigen::RowVectorXd>(values, p + 1);
    }
  }
  // W x = Σ B_a(ξ¹) Q_ab B_b(ξ²)
  const Eigen::Index nu = b[0].cols(), nv = b[1].cols(), size = b[0].rows() * b[1].rows();
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, grid_points, D == 2 ? 1 : grid_points> weight;
  const double* q = bezier_.data() + elements_[at(element)].bezier;
  for (int i = rows_ - 1; i >= 0; --i) {
    const Eigen::Map<const MatrixX> bezier(q + i * nu * nv, nu, nv);
    const Values along = b[0].lazyProduct(bezier);
    if (i == D) {
      weight = along.lazyProduct(b[1].transpose());
      continue;
    }
    Eigen::Map<MatrixX> out(positions + i * size, b[0].rows(), b[1].rows());
    out.noalias() = along.lazyProduct(b[1].transpose());
    if (!polynomial_) out.array() /= weight.array();
  }
}

/// w N_a and its first derivatives: value, then one direction after the other.
template <int D> template <int P> void Surface<D>::weighted_functions(FacePoint<D>& point, int order) const {
  const int* local = nodes(point.element);
  Bernsteins b;
  bernsteins<P>(point.element, point.xi, order, b);
  double along[2][2 * row]; // N_a of one direction and their derivatives
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
        for (int l = 0; l < points; ++l) sum += c[a * points + l] * b[at(d)][at(k * points + l)];
        along[d][k * n + a] = sum;
      }
  }
  const int nu = count[0], nv = D == 2 ? 1 : count[1];
  for (int j = 0, a = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i, ++a) {
      const double w = polynomial_ ? 1 : weights_(local[a]), v = D == 2 ? 1 : along[1][j];
      point.value[at(a)] = w * along[0][i] * v;
      if (order == 0) continue;
      point.derivative[0][at(a)] = w * along[0][nu + i] * v;
      if constexpr (D == 3) point.derivative[1][at(a)] = w * along[0][i] * along[1][nv + j];
    }
}

template <int D> void Surface<D>::functions(FacePoint<D>& point, int order) const {
  with_degree(point.element, [&]<int P>() { weighted_functions<P>(point, order); });
  if (polynomial_) return;
  // R = wN/W,  R_,α = (w N_,α − R W_,α)/W
  const int n = functions_on(point.element);
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

template class Surface<2>;
template class Surface<3>;

} // namespace signorini::contact
