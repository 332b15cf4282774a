#include "contact/face/surface.hpp"

#include "contact/constants.hpp"

#include <algorithm>
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

} // namespace

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
    : spaces_(row.directions()), functions_(std::move(functions)), weights_(row.weights()),
      polynomial_((weights_.array() == weights_(0)).all()), orientation_(orientation), reference_(row.points()),
      points_(reference_) {
  for (std::size_t d = 0; d < spaces_.size(); ++d) ends_[d] = {spaces_[d].first(), spaces_[d].last()};
  tabulate();
}

/// Nodes of all elements, with the Bézier points in the reference configuration.
template <int D> void Surface<D>::tabulate() {
  const nurbs::Space1D &u = spaces_.front(), &v = spaces_.back();
  elements_.clear();
  nodes_.clear();
  bezier_.clear();
  for (int e = 0, count = D == 2 ? u.elements() : u.elements() * v.elements(); e < count; ++e) {
    Element element{{}, 1, 1, nodes_.size(), bezier_.size()};
    nurbs::ElementFunctions functions;
    for (std::size_t d = 0; d < D - 1; ++d) {
      element.index[d] = d == 0 ? e % u.elements() : e / u.elements();
      functions.along[d] = spaces_[d].functions_on(element.index[d]);
      functions.stride[d] = d == 0 ? 1 : u.functions();
      element.functions *= std::ssize(functions.along[d]);
      element.points *= spaces_[d].degree(element.index[d]) + 1;
    }
    bezier_.resize(element.bezier + width() * element.points, 0.0);
    functions.each([&](int node, const std::array<int, 3>&) { nodes_.push_back(node); });
    most_functions_ = std::max(most_functions_, element.functions);
    elements_.push_back(element);
  }
  const int last = *std::max_element(functions_.begin(), functions_.end());
  move(std::vector<double>(D * (last + 1), 0.0).data());
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

/// Length of the last element at an end of direction α as its tangent at the end tells it, |x,_α| Δξ^α; of surfaces the
/// longest at the ends and middles of the border's elements.
template <int D> double Surface<D>::last_length(int alpha, bool at_end) const {
  FaceGeometry<D> point;
  double longest = 0;
  for (int e = 0; e < elements(); ++e) {
    if (neighbor(e, alpha, at_end) >= 0) continue;
    const auto [from, to] = interval(e, alpha);
    for (const double across : border_samples) {
      FaceCoordinates<D> xi;
      for (int a = 0; a < D - 1; ++a) {
        const auto [first, last] = interval(e, a);
        xi(a) = a == alpha ? (at_end ? to : from) : first + across * (last - first);
      }
      locate(e, xi, 1, point);
      longest = std::max(longest, point.tangent[alpha].norm() * (to - from));
    }
  }
  return longest;
}

template <int D> void Surface<D>::extend(double part, double longest) {
  const std::vector<nurbs::Space1D> own = spaces_;
  std::array<std::array<double, 2>, D - 1> parts{};
  for (int a = 0; a < D - 1; ++a)
    for (const bool at_end : {false, true}) {
      if (!open_ends(a)[at_end]) continue;
      const auto [from, to] = own[a].interval(at_end ? own[a].elements() - 1 : 0);
      parts[a][at_end] = std::min(part, longest / last_length(a, at_end));
      beyond_[a][at_end] = parts[a][at_end] * (to - from);
    }
  for (std::size_t a = 0; a < D - 1; ++a) spaces_[a] = extended(own[a], parts[a], beyond_[a]);
  tabulate();
  // Weights that decrease steeply towards an end become negative beyond it; then a shorter extension is tried.
  for (const Element& element : elements_)
    for (int k = 0; k < element.points && !polynomial_; ++k)
      if (bezier_[element.bezier + width() * k + D] <= 0) {
        spaces_ = own;
        tabulate();
        return extend(part / 2, longest / 2);
      }
}

template <int D> double Surface<D>::fade(const FaceCoordinates<D>& xi, FaceCoordinates<D>& rate) const {
  double product = 1;
  rate.setZero();
  for (int a = 0; a < D - 1; ++a) {
    const bool behind = xi(a) > ends_[a][1];
    const double length = beyond_[a][behind], out = behind ? xi(a) - ends_[a][1] : ends_[a][0] - xi(a);
    if (out <= 0 || length == 0) continue;
    // w = (1 − s)² (1 + 2s),  s the distance from the end relative to the extension
    const double s = std::min(out / length, 1.0), w = (1 - s) * (1 - s) * (1 + 2 * s);
    rate *= w;
    rate(a) = product * (behind ? -6 : 6) * s * (1 - s) / length;
    product *= w;
  }
  return product;
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

template <int D> typename Surface<D>::OwnElement Surface<D>::own_element(int element) const {
  OwnElement own{0, {}};
  for (int a = 0; a < D - 1; ++a) {
    const int before = beyond_[a][0] > 0, after = beyond_[a][1] > 0;
    own.index[a] = std::clamp(index(element, a) - before, 0, direction(a).elements() - before - after - 1);
  }
  for (std::size_t f = 0; f < places_.size(); ++f) {
    const auto& [way, elements, first, width] = places_[f];
    OwnElement found{static_cast<int>(f), {}};
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

template class Surface<2>;
template class Surface<3>;

} // namespace signorini::contact
