#pragma once
// Search for the elements of a face near a point: a tree of bounding boxes, distances within which elements have one
// foot point only, and points that have none.

#include "contact/face/surface.hpp"

#include <vector>

namespace signorini::contact {

/// The elements from first to last in each direction around an element that share borders and corners with it, without
/// kinks between them.
struct Neighborhood {
  std::array<int, 2> first, last;
};
template <int D> Neighborhood smooth_neighborhood(const Surface<D>& surface, int element);
template <int D> bool smoothly_adjacent(const Surface<D>& surface, int element, int other);

/// Bounding boxes of a face's elements in a binary tree that halves the grid of elements; moving the face changes the
/// boxes, not the tree.
template <int D> class ElementBoxes {
public:
  /// Computes boxes and distances of the surface's current shape. Must always be called with the same surface.
  void update(const Surface<D>& surface);
  /// Squared diagonal of an element's box.
  double diagonal2(int element) const {
    const Box& box = nodes_[leaves_[element]].box;
    return (box.upper - box.lower).squaredNorm();
  }
  /// Squared distance below which a regular foot point on an element is the closest point of its smooth neighborhood.
  double unique_distance2(int element) const { return unique_distance2_[element]; }
  /// True only if no line from x is normal to the face, so that the closest point is an open end. False where it may be
  /// at a kink, a pole or a seam.
  bool is_beyond_ends(const Vec<D>& x) const { return !nodes_.empty() && !may_have_foot(0, x); }

  /// Calls visit(element) for the elements whose boxes are nearer to x than `distance2()` (a squared distance,
  /// evaluated again before every visit), boxes near x first.
  template <class Distance2, class Visit> void near(const Vec<D>& x, Distance2 distance2, Visit visit) const {
    if (!nodes_.empty()) descend(0, nodes_[0].box.distance2(x), x, distance2, visit);
  }

private:
  struct Box {
    Vec<D> lower, upper;
    /// Squared lower bound of the distance from x to the element.
    double distance2(const Vec<D>& x) const { return (lower - x).cwiseMax(x - upper).cwiseMax(0.0).squaredNorm(); }
    Box joined(const Box& other) const { return {lower.cwiseMin(other.lower), upper.cwiseMax(other.upper)}; }
  };
  /// The first child follows its parent directly.
  struct Node {
    int element = -1; ///< of a leaf; −1 otherwise
    int second = -1;  ///< index of the second child
    /// True per direction and end if all its borders there are smooth or open ends: not a kink, a pole or a seam.
    std::array<std::array<bool, 2>, D - 1> plain;
    Box box;
    std::array<Box, D - 1> tangents; ///< around τ_α
  };
  void find_unique_distances(const Surface<D>& surface);
  bool may_have_foot(int index, const Vec<D>& x) const;
  void build(const Surface<D>& surface, std::array<int, 2> first, std::array<int, 2> last);

  template <class Distance2, class Visit>
  void descend(int index, double own, const Vec<D>& x, Distance2& distance2, Visit& visit) const {
    if (own >= distance2()) return;
    const Node& node = nodes_[index];
    if (node.element >= 0) return visit(node.element);
    int near = index + 1, far = node.second;
    double to_near = nodes_[near].box.distance2(x), to_far = nodes_[far].box.distance2(x);
    if (to_far < to_near) {
      std::swap(near, far);
      std::swap(to_near, to_far);
    }
    descend(near, to_near, x, distance2, visit);
    descend(far, to_far, x, distance2, visit);
  }

  std::vector<Node> nodes_;
  std::vector<int> leaves_; ///< per element
  std::vector<double> unique_distance2_;
  std::vector<DerivativeBounds<D>> bounds_; ///< working space
};

} // namespace signorini::contact
