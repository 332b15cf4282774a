#include "contact/face/search.hpp"

#include "contact/constants.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::contact {

namespace {

/// Squared distance d of a foot point x(ξ₁) below which no other point x(ξ₂) of a part is nearer. With the tangents A
/// amid their box, |J − A| ≤ ρ |A| in all directions δ = ξ₂ − ξ₁, and since the line to x(ξ₁), of length d, is normal
/// to J(ξ₁), the squared distance grows by at least
///     |c|² − 2 d |c − J(ξ₁) δ|,   c = x(ξ₂) − x(ξ₁),   |c| ≥ (1 − ρ) |A δ|,   |c − J(ξ₁) δ| ≤ ½ max |x_,αβ δ^α δ^β|.
/// In the lengths y_α = |A_α| |δ^α|: |A δ|² ≥ (1 − |cos|) |y|², cos that of the angle between A₁ and A₂, and
/// |x_,αβ δ^α δ^β| ≤ κ |y|², κ the largest eigenvalue of |x_,αβ|/(|A_α| |A_β|). So d is (1 − ρ)² (1 − |cos|)/κ.
template <int D> double least_ambiguous2(const DerivativeBounds<D>& bounds) {
  std::array<Vec<D>, D - 1> tangent;
  double lengths[D - 1], spread2 = 0;
  for (std::size_t a = 0; a < D - 1; ++a) {
    tangent[a] = 0.5 * (bounds.lower[a] + bounds.upper[a]);
    lengths[a] = tangent[a].norm();
    if (!(lengths[a] > 0)) return 0;
    spread2 += (0.25 * (bounds.upper[a] - bounds.lower[a]).squaredNorm()) / (lengths[a] * lengths[a]);
  }
  double skew = 1, curvature; // 1 − |cos|, κ
  if constexpr (D == 2) {
    curvature = bounds.second[0] / (lengths[0] * lengths[0]);
  } else {
    skew -= std::abs(tangent[0].dot(tangent[1])) / (lengths[0] * lengths[1]);
    if (!(skew > 0)) return 0;
    const double a = bounds.second[0] / (lengths[0] * lengths[0]), b = bounds.second[1] / (lengths[0] * lengths[1]);
    const double c = bounds.second[2] / (lengths[1] * lengths[1]);
    curvature = 0.5 * (a + c) + std::hypot(0.5 * (a - c), b);
  }
  const double rest = 1 - std::sqrt(spread2 / skew); // 1 − ρ
  if (rest <= 0) return 0;
  const double distance = rest * rest * skew / curvature;
  return distance * distance;
}

template <int D> bool is_open_end(const Surface<D>& surface, int element, int alpha, bool at_end) {
  return surface.neighbor(element, alpha, at_end) < 0 &&
         surface.sheet_data(surface.sheet(element)).extension.lengths[alpha][at_end] > 0;
}

/// True if a border of an element is not a kink, a pole, a seam or an end.
template <int D> bool is_smooth_border(const Surface<D>& surface, int element, int alpha, bool at_end) {
  return surface.neighbor(element, alpha, at_end) >= 0 &&
         surface.along(element, alpha).smoothness()[surface.index(element, alpha) + at_end] > 0;
}

/// Indices of an element in its sheet.
template <int D> std::array<int, 2> place_of(const Surface<D>& surface, int element) {
  return {surface.index(element, 0), D == 2 ? 0 : surface.index(element, D - 2)};
}

} // namespace

template <int D> Neighborhood smooth_neighborhood(const Surface<D>& surface, int element) {
  const std::array<int, 2> place = place_of(surface, element);
  Neighborhood block{place, place};
  for (std::size_t d = 0; d < D - 1; ++d) {
    // No border is smooth at the ends.
    const std::vector<int>& smoothness = surface.along(element, static_cast<int>(d)).smoothness();
    const int own = block.first[d];
    if (smoothness[own] > 0) --block.first[d];
    if (smoothness[own + 1] > 0) ++block.last[d];
  }
  return block;
}

template <int D> bool smoothly_adjacent(const Surface<D>& surface, int element, int other) {
  if (surface.sheet(element) != surface.sheet(other)) return false;
  const std::array<int, 2> place = place_of(surface, other);
  const Neighborhood block = smooth_neighborhood(surface, element);
  return block.first[0] <= place[0] && place[0] <= block.last[0] && block.first[1] <= place[1] &&
         place[1] <= block.last[1];
}

template <int D> void ElementBoxes<D>::find_unique_distances(const Surface<D>& surface) {
  unique_distance2_.resize(bounds_.size());
  for (int e = 0; e < surface.elements(); ++e) {
    const int n = surface.along(e, 0).elements(), start = surface.first_element(surface.sheet(e));
    const Neighborhood block = smooth_neighborhood(surface, e);
    DerivativeBounds<D> all = bounds_[e];
    for (int j = block.first[1]; j <= block.last[1]; ++j)
      for (int i = block.first[0]; i <= block.last[0]; ++i) all.include(bounds_[start + i + n * j]);
    unique_distance2_[e] = least_ambiguous2(all);
  }
}

/// Where (x − x(ξ))·τ_α > 0 on all elements of a node, x(ξ) and τ_α in their boxes, the distance decreases along ξ^α up
/// to their last border. If that is an open end or smooth, the closest point of the face is at the end or on other
/// elements. For the other sign the same holds for their first border [theory 5.10].
template <int D> bool ElementBoxes<D>::falls_beyond(const Node& node, const Borders& ends, const Vec<D>& x) {
  const Vec<D> first = x - node.box.upper, last = x - node.box.lower;
  for (std::size_t alpha = 0; alpha < D - 1; ++alpha) {
    if (!ends[alpha][0] && !ends[alpha][1]) continue;
    const Box& tangent = node.tangents[alpha];
    const Vec<D> a = first.cwiseProduct(tangent.lower), b = first.cwiseProduct(tangent.upper);
    const Vec<D> c = last.cwiseProduct(tangent.lower), d = last.cwiseProduct(tangent.upper);
    if (ends[alpha][1] && a.cwiseMin(b).cwiseMin(c).cwiseMin(d).sum() > 0) return true;
    if (ends[alpha][0] && a.cwiseMax(b).cwiseMax(c).cwiseMax(d).sum() < 0) return true;
  }
  return false;
}

template <int D> bool ElementBoxes<D>::may_have_foot(int index, const Vec<D>& x) const {
  const Node& node = nodes_[index];
  if (falls_beyond(node, node.plain, x)) return false;
  return node.element >= 0 || may_have_foot(index + 1, x) || may_have_foot(node.second, x);
}

template <int D> void ElementBoxes<D>::update(const Surface<D>& surface) {
  if (nodes_.empty()) {
    leaves_.resize(surface.elements());
    build_sheets(surface, 0, surface.sheets());
  }
  bounds_.clear();
  for (int e = 0; e < surface.elements(); ++e) bounds_.push_back(derivative_bounds(surface.bezier(e)));
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    Node& node = nodes_[i];
    if (node.element >= 0) {
      bounds(surface.bezier(node.element), node.box.lower, node.box.upper);
      const DerivativeBounds<D>& rates = bounds_[node.element];
      for (std::size_t a = 0; a < D - 1; ++a) node.tangents[a] = {rates.lower[a], rates.upper[a]};
      continue;
    }
    const Node &a = nodes_[i + 1], &b = nodes_[node.second];
    node.box = a.box.joined(b.box);
    for (std::size_t d = 0; d < D - 1; ++d) node.tangents[d] = a.tangents[d].joined(b.tangents[d]);
  }
  find_unique_distances(surface);
  if (!bodies_.empty()) update_cones(surface);
}

// ── What points see ──────────────────────────────────────────────────────────────────────────────────────────────────

template <int D> void ElementBoxes<D>::update_cones(const Surface<D>& surface) {
  facing_.resize(nodes_.size());
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    const Node& node = nodes_[i];
    Facing& facing = facing_[i];
    if (node.element >= 0) {
      const int sheet = surface.sheet(node.element);
      facing.body = bodies_[sheet];
      facing.cone = normal_cone(bounds_[node.element], surface.sheet_data(sheet).orientation);
    } else {
      const Facing &a = facing_[i + 1], &b = facing_[node.second];
      facing.body = a.body == b.body ? a.body : -1;
      facing.cone = joined(a.cone, b.cone);
    }
    // A normal of the cone is at least (angle to the axis) − half away.
    facing.hides = least_facing > facing.cone.half ? std::cos(least_facing - facing.cone.half) : 1.0;
  }
}

template <int D> void ElementBoxes<D>::note_motion(const Surface<D>& accepted, const Surface<D>& now) {
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    const Node& node = nodes_[i];
    Box& moved = facing_[i].moved;
    if (node.element >= 0)
      bounds_of_motion(accepted.bezier(node.element), now.bezier(node.element), moved.lower, moved.upper);
    else
      moved = facing_[i + 1].moved.joined(facing_[node.second].moved);
  }
}

namespace {

/// True if a plane normal to an axis parts two elements by more than a distance.
template <int D>
bool are_parted(const BezierElement<D>& one, const BezierElement<D>& other, const Vec<D>& axis, double distance) {
  return least_along<D>(one, axis) + least_along<D>(other, -axis) > distance ||
         least_along<D>(other, axis) + least_along<D>(one, -axis) > distance;
}

} // namespace

template <int D>
bool ElementBoxes<D>::is_alone(const Surface<D>& surface, int element, const Reach& reach,
                               std::span<const int> left_out) const {
  const Box& box = nodes_[leaves_[element]].box;
  const Facing& from = facing_[leaves_[element]];
  const double hidden = least_facing - turning_margin - from.cone.half;
  const auto is_clear = [&](int index, const auto& self) -> bool {
    const Node& node = nodes_[index];
    const Facing& facing = facing_[index];
    const bool own = facing.body == from.body;
    const double limit = reach.of(own) + from.moved.farthest(facing.moved);
    if (node.box.distance2(box) > limit * limit) return true;
    const double least = hidden - facing.cone.half;
    if (own && least > 0 && from.cone.axis.dot(facing.cone.axis) > std::cos(least)) return true;
    if (node.element < 0) return self(index + 1, self) && self(node.second, self);
    if (node.element == element || std::ranges::find(left_out, node.element) != left_out.end()) return true;
    // Boxes of flat elements next to each other that lie askew overlap.
    const BezierElement<D> one = surface.bezier(element), other = surface.bezier(node.element);
    const Vec<D>&a = from.cone.axis, &b = facing.cone.axis;
    if (are_parted<D>(one, other, a, limit) || are_parted<D>(one, other, b, limit)) return true;
    if constexpr (D == 3) return are_parted<D>(one, other, a.cross(b).normalized(), limit);
    return false;
  };
  return is_clear(0, is_clear);
}

/// At a foot x − x̄ = g n̄; if (x − x(ξ))·a < −depth all over the element, a the axis of a cone of normals that is
/// narrower than a half space, g < 0 and |g| ≥ |(x − x̄)·a| > depth [theory 8.4].
template <int D>
bool ElementBoxes<D>::is_behind(const Surface<D>& surface, int element, const Vec<D>& x, double depth) const {
  const Facing& facing = facing_[leaves_[element]];
  if (!(facing.cone.half < NormalCone<D>::pi / 2)) return false;
  for (const auto& ends : nodes_[leaves_[element]].smooth)
    if (!ends[0] || !ends[1]) return false;
  return least_along<D>(surface.bezier(element), facing.cone.axis) > x.dot(facing.cone.axis) + depth;
}

// ── Tree ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Builds the tree of sheets first … last − 1.
template <int D> void ElementBoxes<D>::build_sheets(const Surface<D>& surface, int first, int last) {
  if (last - first == 1) {
    const int u = surface.direction(0, first).elements();
    const int count = surface.first_element(last) - surface.first_element(first);
    return build(surface, first, {0, 0}, {u, count / u});
  }
  const std::size_t index = nodes_.size();
  nodes_.emplace_back();
  build_sheets(surface, first, (first + last) / 2);
  nodes_[index].second = std::ssize(nodes_);
  build_sheets(surface, (first + last) / 2, last);
}

/// Builds the tree of the elements first … last − 1 in both directions of a sheet.
template <int D>
void ElementBoxes<D>::build(const Surface<D>& surface, int sheet, std::array<int, 2> first, std::array<int, 2> last) {
  const std::size_t index = nodes_.size();
  nodes_.emplace_back();
  const int u = last[0] - first[0], v = last[1] - first[1];
  if (u == 1 && v == 1) {
    const int element = surface.first_element(sheet) + first[0] + surface.direction(0, sheet).elements() * first[1];
    nodes_[index].element = element;
    for (int a = 0; a < D - 1; ++a)
      for (const bool at_end : {false, true}) {
        Node& leaf = nodes_[index];
        leaf.smooth[a][at_end] = is_smooth_border(surface, element, a, at_end);
        leaf.plain[a][at_end] = leaf.smooth[a][at_end] || is_open_end(surface, element, a, at_end);
      }
    leaves_[element] = static_cast<int>(index);
    return;
  }
  const std::size_t d = u >= v ? 0 : 1;
  std::array<int, 2> end = last, start = first;
  end[d] = start[d] = (first[d] + last[d]) / 2;
  build(surface, sheet, first, end);
  nodes_[index].second = std::ssize(nodes_);
  build(surface, sheet, start, last);
  const Node &a = nodes_[index + 1], &b = nodes_[nodes_[index].second];
  for (const auto borders : {&Node::smooth, &Node::plain})
    for (std::size_t k = 0; k < D - 1; ++k) {
      (nodes_[index].*borders)[k][0] = (a.*borders)[k][0] && (k == d || (b.*borders)[k][0]);
      (nodes_[index].*borders)[k][1] = (b.*borders)[k][1] && (k == d || (a.*borders)[k][1]);
    }
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template Neighborhood smooth_neighborhood(const Surface<D>&, int);                                                   \
  template bool smoothly_adjacent(const Surface<D>&, int, int);                                                        \
  template class ElementBoxes<D>;
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
