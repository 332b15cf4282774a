#include "contact/face/surface.hpp"

#include "contact/constants.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace signorini::contact {

namespace {

/// 0, 1, … count − 1.
std::vector<int> numbers(int count) {
  std::vector<int> list(count);
  std::iota(list.begin(), list.end(), 0);
  return list;
}

/// A space extended along its tangent beyond its ends by elements of the given `parts` of the last elements (0: no
/// extension). The Bézier points of a new element are
///     Q_k = Q_end + k part (Q_end − Q_next).
nurbs::Space1D extended(const nurbs::Space1D& space, std::array<double, 2> parts, std::array<double, 2> lengths) {
  std::vector<double> breaks = space.breaks();
  std::vector<int> smoothness = space.smoothness();
  std::vector<nurbs::Element1D> elements;
  for (int e = 0; e < space.elements(); ++e) elements.push_back(space.element(e));
  for (const bool at_end : {false, true}) {
    const double part = parts[at_end];
    if (part == 0) continue;
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

/// The same space with other parameters.
nurbs::Space1D shifted(const nurbs::Space1D& space, double by) {
  std::vector<double> breaks = space.breaks();
  for (double& parameter : breaks) parameter += by;
  std::vector<nurbs::Element1D> elements;
  for (int e = 0; e < space.elements(); ++e) elements.push_back(space.element(e));
  return {std::move(breaks), space.smoothness(), elements};
}

/// Length of the last element at an end of direction α of a sheet as its tangent at the end tells it, |x,_α| Δξ^α; of
/// surfaces the longest at the ends and middles of the border's elements.
template <int D> double last_length(const Surface<D>& face, int sheet, int alpha, bool at_end) {
  FaceGeometry<D> point;
  double longest = 0;
  for (int e = face.first_element(sheet); e < face.first_element(sheet + 1); ++e) {
    if (face.neighbor(e, alpha, at_end) >= 0) continue;
    const auto [from, to] = face.interval(e, alpha);
    for (const double across : border_samples) {
      FaceCoordinates<D> xi;
      for (int a = 0; a < D - 1; ++a) {
        const auto [first, last] = face.interval(e, a);
        xi(a) = a == alpha ? (at_end ? to : from) : first + across * (last - first);
      }
      face.locate(e, xi, 1, point);
      longest = std::max(longest, point.tangent[alpha].norm() * (to - from));
    }
  }
  return longest;
}

/// Squared distance of a Bézier point from its earlier place.
template <int D, int W> double moved2(bool polynomial, const double* before, const double* now) {
  using Point = Eigen::Map<const Vec<D>>;
  double change2 = (Point(now) - Point(before)).squaredNorm();
  if constexpr (W == 4)
    if (!polynomial) change2 /= now[D] * now[D]; // weights do not change
  return change2;
}

template <int D> Sheet<D> make_sheet(const std::vector<nurbs::Space1D>& directions, double orientation) {
  Sheet<D> sheet{orientation};
  for (std::size_t d = 0; d < D - 1; ++d) sheet.extension.ends[d] = {directions[d].first(), directions[d].last()};
  return sheet;
}

constexpr int face_row = nurbs::max_degree + 1;

/// w N_a and its first derivatives, w = 1 without weights: value, then one direction after the other.
template <int P, int D>
void weighted_functions(const Surface<D>& face, const VectorX* weights, FacePoint<D>& point, int order) {
  const int* local = face.nodes(point.element);
  Bernsteins<D> b;
  bernsteins<P, 1>(face.bezier(point.element), point.xi, b);
  double along[2][2 * face_row]; // N_a of one direction and their derivatives
  int count[2] = {1, 1};
  for (int d = 0; d < D - 1; ++d) {
    const auto extraction = face.along(point.element, d).extraction(face.index(point.element, d));
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
      const double w = weights ? (*weights)(local[a]) : 1, v = D == 2 ? 1 : along[1][j];
      point.value[a] = w * along[0][i] * v;
      if (order == 0) continue;
      point.derivative[0][a] = w * along[0][nu + i] * v;
      if constexpr (D == 3) point.derivative[1][a] = w * along[0][i] * along[1][nv + j];
    }
}

} // namespace

template <int D> std::array<bool, 2> open_ends(const Surface<D>& face, int alpha, int sheet) {
  const int nu = face.direction(0, sheet).functions(), nv = D == 2 ? 1 : face.direction(D - 2, sheet).functions();
  const auto reference = face.reference().middleCols(face.first_function(sheet), nu * nv);
  const int across = alpha == 0 ? nv : nu, step = alpha == 0 ? nu : 1, last = alpha == 0 ? nu - 1 : nu * (nv - 1);
  const double size = (reference.rowwise().maxCoeff() - reference.rowwise().minCoeff()).norm();
  const auto apart = [&](int i, int j) { return (reference.col(i) - reference.col(j)).norm() > same_place * size; };
  bool seam = true;
  std::array<bool, 2> points{D == 3, D == 3}; // borders that are collapsed to one point; never ends of curves
  for (int i = 0; i < across; ++i) {
    seam = seam && !apart(i * step, last + i * step);
    points[0] = points[0] && !apart(0, i * step);
    points[1] = points[1] && !apart(last, last + i * step);
  }
  const auto open = [&](bool at_end) { return !seam && !points[at_end] && !is_linked(face, sheet, alpha, at_end); };
  return {open(false), open(true)};
}

template <int D>
Surface<D>::Surface(const nurbs::Discretization& body, nurbs::Side side, int first, std::vector<int> shared)
    : Surface(body.face(side), body.face_functions(side), nurbs::outward_sign(side)) {
  for (int& function : functions_) function += first;
  shared_ = std::move(shared);
}

template <int D> Surface<D>::Surface(FaceGrid grid) : Surface(grid.row, std::move(grid.nodes), grid.orientation) {
  places_ = std::move(grid.places);
}

template <int D>
Surface<D>::Surface(const nurbs::Patch& patch) : Surface(nurbs::make_row(patch), numbers(patch.functions()), 1) {}

template <int D>
Surface<D>::Surface(const nurbs::Row& row, std::vector<int> functions, double orientation)
    : FaceMesh<D>(row.directions()), sheets_{make_sheet<D>(row.directions(), orientation)},
      functions_(std::move(functions)), weights_(row.weights()), polynomial_((weights_.array() == weights_(0)).all()),
      reference_(row.points()), points_(reference_) {
  set_mesh({row.directions()});
}

template <int D> Surface<D>::Surface(const std::vector<Surface>& faces) : Surface(faces.front()) {
  std::vector<std::vector<nurbs::Space1D>> sheets;
  std::vector<double> weights;
  std::vector<Vec<D>> reference;
  functions_.clear();
  shared_.clear();
  sheets_.clear();
  places_.clear();
  double start = 0;
  for (const Surface& face : faces) {
    std::vector<nurbs::Space1D> directions;
    for (int d = 0; d < D - 1; ++d) directions.push_back(face.direction(d));
    const double length = directions[0].last() - directions[0].first();
    // Extensions on both sides are shorter than the last elements.
    directions[0] = shifted(directions[0], start + length - directions[0].first());
    start = directions[0].last() + length;
    sheets.push_back(std::move(directions));
    sheets_.push_back(make_sheet<D>(sheets.back(), face.sheets_[0].orientation));
    // A constant factor on the weights of a face changes nothing; so all are 1 where none is rational.
    for (int i = 0; i < face.functions(); ++i) {
      functions_.push_back(face.body_function(i));
      shared_.push_back(face.shared(i));
      weights.push_back(face.weights_(i) / face.weights_(0));
      reference.push_back(face.reference_.col(i));
    }
  }
  weights_ = Eigen::Map<const VectorX>(weights.data(), std::ssize(weights));
  polynomial_ = (weights_.array() == weights_(0)).all();
  reference_.resize(D, std::ssize(reference));
  for (int i = 0; i < functions(); ++i) reference_.col(i) = reference[i];
  points_ = reference_;
  set_mesh(std::move(sheets));
  links_ = find_links(*this);
}

/// Sets the elements, with the Bézier points in the reference configuration.
template <int D> void Surface<D>::set_mesh(std::vector<std::vector<nurbs::Space1D>> sheets) {
  static_cast<FaceMesh<D>&>(*this) = FaceMesh<D>(std::move(sheets));
  bezier_.assign((D == 2 && polynomial_ ? 2 : 4) * this->first_bezier(this->elements()), 0.0);
  const int last = *std::max_element(functions_.begin(), functions_.end());
  move(std::vector<double>(D * (last + 1), 0.0).data());
}

template <int D> void Surface<D>::extend(double part, double longest) {
  std::vector<std::vector<nurbs::Space1D>> own(this->sheets()), longer(this->sheets());
  for (int s = 0; s < this->sheets(); ++s)
    for (int a = 0; a < D - 1; ++a) {
      own[s].push_back(this->direction(a, s));
      std::array<double, 2> parts{};
      for (const bool at_end : {false, true}) {
        if (!open_ends(*this, a, s)[at_end]) continue;
        const auto [from, to] = own[s][a].interval(at_end ? own[s][a].elements() - 1 : 0);
        parts[at_end] = std::min(part, longest / last_length(*this, s, a, at_end));
        sheets_[s].extension.lengths[a][at_end] = parts[at_end] * (to - from);
      }
      longer[s].push_back(extended(own[s][a], parts, sheets_[s].extension.lengths[a]));
    }
  set_mesh(std::move(longer));
  if (!polynomial_)
    // Weights that decrease steeply towards an end become negative beyond it; then a shorter extension is tried.
    for (std::size_t q = D; q < bezier_.size(); q += 4)
      if (bezier_[q] <= 0) {
        set_mesh(std::move(own));
        return extend(part / 2, longest / 2);
      }
  if (!links_.empty()) links_ = find_links(*this);
}

template <int D> double Extension<D>::fade(const FaceCoordinates<D>& xi, FaceCoordinates<D>& rate) const {
  double product = 1;
  rate.setZero();
  for (int a = 0; a < D - 1; ++a) {
    const bool behind = xi(a) > ends[a][1];
    const double length = lengths[a][behind], out = behind ? xi(a) - ends[a][1] : ends[a][0] - xi(a);
    if (out <= 0 || length == 0) continue;
    // w = (1 − s)² (1 + 2s),  s the distance from the end relative to the extension
    const double s = std::min(out / length, 1.0), w = (1 - s) * (1 - s) * (1 + 2 * s);
    rate *= w;
    rate(a) = product * (behind ? -6 : 6) * s * (1 - s) / length;
    product *= w;
  }
  return product;
}

template <int D> double Surface<D>::move(const double* displacement) {
  for (int i = 0; i < functions(); ++i)
    for (int k = 0; k < D; ++k) points_(k, i) = reference_(k, i) + displacement[D * body_function(i) + k];
  double distance = 0;
  with_width<D>(polynomial_, [&]<int W>() { distance = update_bezier<W>(); });
  return distance;
}

template <int D> OwnElement<D> own_element(const Surface<D>& surface, int element) {
  OwnElement<D> own{surface.sheet(element), {}};
  for (int a = 0; a < D - 1; ++a) {
    const auto [start, end] = surface.sheet_data(own.face).extension.lengths[a];
    const int before = start > 0, after = end > 0;
    own.index[a] =
        std::clamp(surface.index(element, a) - before, 0, surface.along(element, a).elements() - before - after - 1);
  }
  for (std::size_t f = 0; f < surface.places().size(); ++f) {
    const auto& [way, elements, first, width] = surface.places()[f];
    OwnElement<D> found{static_cast<int>(f), {}};
    bool inside = true;
    for (int k = 0; k < D - 1; ++k) {
      const int there = own.index[way.to[k]] - first[way.to[k]];
      found.index[k] = way.flip[k] ? elements[k] - 1 - there : there;
      inside = inside && there >= 0 && there < elements[k];
    }
    if (inside) return found;
  }
  return own;
}

template <int D> double distance_moved(const Surface<D>& before, const Surface<D>& now) {
  double largest2 = 0;
  for (int e = 0; e < now.elements(); ++e) {
    const BezierElement<D> first = before.bezier(e), last = now.bezier(e);
    with_width<D>(last.polynomial, [&]<int W>() {
      for (int q = 0; q < W * last.count(); q += W)
        largest2 = std::max(largest2, moved2<D, W>(last.polynomial, first.points + q, last.points + q));
    });
  }
  return std::sqrt(largest2);
}

template <int D> BezierElement<D> Surface<D>::bezier(int element) const {
  BezierElement<D> result{nullptr, polynomial_, {}, {}};
  for (int d = 0; d < D - 1; ++d) {
    result.degree[d] = this->degree(element, d);
    result.interval[d] = this->interval(element, d);
  }
  result.points = bezier_.data() + result.width() * this->first_bezier(element);
  return result;
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
    largest2 = std::max(largest2, moved2<D, W>(polynomial_, q, row.data()));
    std::copy_n(row.data(), W, q);
  };
  for (int e = 0; e < this->elements(); ++e) {
    const int* local = this->nodes(e);
    const auto c = this->along(e, 0).extraction(this->index(e, 0));
    const int nu = static_cast<int>(c.cols()), mu = static_cast<int>(c.rows()), mv = this->functions_on(e) / mu;
    double* q = bezier_.data() + W * this->first_bezier(e);
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
      const auto d = this->along(e, 1).extraction(this->index(e, 1));
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

template <int D> void Surface<D>::functions(FacePoint<D>& point, int order) const {
  with_degree(bezier(point.element),
              [&]<int P>() { weighted_functions<P>(*this, polynomial_ ? nullptr : &weights_, point, order); });
  if (polynomial_) return;
  // R = wN/W,  R_,α = (w N_,α − R W_,α)/W
  const int n = this->functions_on(point.element);
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

template std::array<bool, 2> open_ends(const Surface<2>&, int, int);
template std::array<bool, 2> open_ends(const Surface<3>&, int, int);
template struct Extension<2>;
template struct Extension<3>;
template class Surface<2>;
template class Surface<3>;
template OwnElement<2> own_element(const Surface<2>&, int);
template OwnElement<3> own_element(const Surface<3>&, int);
template double distance_moved(const Surface<2>&, const Surface<2>&);
template double distance_moved(const Surface<3>&, const Surface<3>&);

} // namespace signorini::contact
