#pragma once
// Search for the elements of a face near a point: a tree of bounding boxes, distances within which elements have one
// foot point only, points that have none, and parts whose normals cannot face that of a point.

#include "contact/face/normal_cone.hpp"
#include "contact/face/surface.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace signorini::contact {

/// The elements from first to last in each direction around an element that share borders and corners with it, without
/// kinks between them.
struct Neighborhood {
  std::array<int, 2> first, last;
};
template <int D> Neighborhood smooth_neighborhood(const Surface<D>& surface, int element);
template <int D> bool smoothly_adjacent(const Surface<D>& surface, int element, int other);

/// How far a point of a set of faces, or an element of it, looks for feet: up to their motion relative to it since the
/// accepted state, and by these lengths farther.
struct Reach {
  double own = std::numeric_limits<double>::infinity(); ///< for parts of its own body
  double others = std::numeric_limits<double>::infinity();

  double of(bool own_body) const { return own_body ? own : others; }
};

/// What a point of a set of faces sees of it: parts within its reach, of its own body only if their normals differ
/// enough from its own.
template <int D> struct Sight {
  int body = -1; ///< of the point; −1: it sees everything
  Vec<D> normal = Vec<D>::Zero();
  std::span<const int> left_out = {}; ///< elements that it never touches
  Reach reach = {};
  Vec<D> moved = Vec<D>::Zero(); ///< its displacement since the accepted state
};

/// Bounding boxes of a face's elements in a binary tree that halves the grid of elements; moving the face changes the
/// boxes, not the tree.
template <int D> class ElementBoxes {
public:
  /// `bodies`: by sheet of a set of faces, the body behind it; empty if nothing depends on what points see.
  ElementBoxes(std::vector<int> bodies = {}) : bodies_(std::move(bodies)) {}
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
  /// evaluated again before every visit), boxes near x first, without those that a point with this sight cannot see.
  template <class Distance2, class Visit>
  void near(const Vec<D>& x, const Sight<D>& sight, Distance2 distance2, Visit visit) const {
    if (!nodes_.empty()) descend(0, nodes_[0].box.distance2(x), x, sight, distance2, visit);
  }
  /// True if there is any such element at any distance.
  bool sees_any(const Vec<D>& x, const Sight<D>& sight) const {
    bool any = false;
    near(
        x, sight, [&] { return any ? 0 : std::numeric_limits<double>::infinity(); }, [&](int) { any = true; });
    return any;
  }
  /// True only if x is farther than `depth` behind every point of an element of a set at which the line to x is normal
  /// to the face, and the distance has no other minima there.
  bool is_behind(const Surface<D>& surface, int element, const Vec<D>& x, double depth) const;

  /// Of a set: notes how far its elements have moved since the accepted state, in which the surface was `accepted`.
  void note_motion(const Surface<D>& accepted, const Surface<D>& now);
  /// A bound on the motion of any element relative to a point with this displacement.
  double relative_motion(const Vec<D>& moved) const { return facing_[0].moved.farthest({moved, moved}); }
  /// True only if no point of an element of a set has a foot on another within this reach, also with normals turned by
  /// `turning_margin`, except on the elements that it never touches.
  bool is_alone(const Surface<D>& surface, int element, const Reach& reach, std::span<const int> left_out) const;

private:
  struct Box {
    Vec<D> lower, upper;
    /// Squared lower bound of the distance from x to the element.
    double distance2(const Vec<D>& x) const { return (lower - x).cwiseMax(x - upper).cwiseMax(0.0).squaredNorm(); }
    double distance2(const Box& other) const {
      return (lower - other.upper).cwiseMax(other.lower - upper).cwiseMax(0.0).squaredNorm();
    }
    /// Upper bound of the distance between points of both.
    double farthest(const Box& other) const { return (upper - other.lower).cwiseMax(other.upper - lower).norm(); }
    Box joined(const Box& other) const { return {lower.cwiseMin(other.lower), upper.cwiseMax(other.upper)}; }
  };
  /// What holds of the borders of a part, per direction and end.
  using Borders = std::array<std::array<bool, 2>, D - 1>;
  /// The first child follows its parent directly.
  struct Node {
    int element = -1; ///< of a leaf; −1 otherwise
    int second = -1;  ///< index of the second child
    Borders smooth{}; ///< all of them are smooth: not a kink, a pole, a seam or an open end
    Borders plain{};  ///< all of them are smooth or open ends
    Box box;
    std::array<Box, D - 1> tangents; ///< around τ_α
  };
  /// What a node of a set shows.
  struct Facing {
    int body; ///< of all its elements; −1: of several
    NormalCone<D> cone;
    double hides; ///< cosine of the angle to the cone's axis above which a point does not see it
    Box moved{Vec<D>::Zero(), Vec<D>::Zero()}; ///< around the displacements since the accepted state
  };
  /// `distance2`: of its box, squared.
  bool sees(int index, const Sight<D>& sight, double distance2) const {
    if (sight.body < 0) return true;
    const Facing& facing = facing_[index];
    const bool own = facing.body == sight.body;
    const double reach = sight.reach.of(own) + facing.moved.farthest({sight.moved, sight.moved});
    return distance2 <= reach * reach && !(own && sight.normal.dot(facing.cone.axis) > facing.hides);
  }
  void update_cones(const Surface<D>& surface);
  void find_unique_distances(const Surface<D>& surface);
  /// True only if the distance from x decreases all over a node up to a border that `ends` allow.
  static bool falls_beyond(const Node& node, const Borders& ends, const Vec<D>& x);
  bool may_have_foot(int index, const Vec<D>& x) const;
  void build_sheets(const Surface<D>& surface, int first, int last);
  void build(const Surface<D>& surface, int sheet, std::array<int, 2> first, std::array<int, 2> last);

  template <class Distance2, class Visit>
  void descend(int index, double own, const Vec<D>& x, const Sight<D>& sight, Distance2& distance2,
               Visit& visit) const {
    if (own >= distance2() || !sees(index, sight, own)) return;
    const Node& node = nodes_[index];
    if (sight.body >= 0 && falls_beyond(node, node.smooth, x)) return;
    if (node.element >= 0) {
      if (std::ranges::find(sight.left_out, node.element) == sight.left_out.end()) visit(node.element);
      return;
    }
    int near = index + 1, far = node.second;
    double to_near = nodes_[near].box.distance2(x), to_far = nodes_[far].box.distance2(x);
    if (to_far < to_near) {
      std::swap(near, far);
      std::swap(to_near, to_far);
    }
    descend(near, to_near, x, sight, distance2, visit);
    descend(far, to_far, x, sight, distance2, visit);
  }

  std::vector<Node> nodes_;
  std::vector<int> leaves_; ///< per element
  std::vector<double> unique_distance2_;
  std::vector<DerivativeBounds<D>> bounds_; ///< working space
  std::vector<int> bodies_;                 ///< by sheet
  std::vector<Facing> facing_;              ///< by node, of a set
};

} // namespace signorini::contact
