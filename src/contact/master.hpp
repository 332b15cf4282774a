#pragma once
// What a slave face is projected onto: the face of another body in motion, or a rigid obstacle.

#include "contact/obstacle.hpp"
#include "contact/projection.hpp"

namespace signorini::contact {

/// Position, kinematics and functions of a master. A rigid one has a single node, its translation: that function is 1
/// everywhere, so that the same residual and tangent serve both.
///
/// A traction that ends with the face would jump whenever a point passes the end, which is where a block that digs its
/// edge into a slab carries most, and nothing would hold a point at a plane of symmetry that rounding, or a small slope
/// of the face, projects beyond it. So the face goes on by a part of its last element, over which the traction fades.
template <int D> class Master {
public:
  Master(Surface<D> face);
  Master(Obstacle<D> obstacle);

  bool rigid() const { return rigid_; }
  /// The face in motion, or the rigid curve; null for a shape in closed form.
  const Surface<D>* surface() const { return surface_ ? &*surface_ : nullptr; }
  /// Number of functions on an element; 1 when rigid.
  int functions_on(int element) const { return rigid_ ? 1 : surface_->functions_on(element); }
  /// On the element that has most.
  int most_functions() const { return rigid_ ? 1 : surface_->most_functions(); }

  /// Takes over displacements, D values per function of the body, or the obstacle's translation. Returns a bound on how
  /// far any point moved.
  double move(const double* displacement);

  /// The closest point to x, see projection.hpp; `point` holds the geometry there (order 2), no functions. Shapes in
  /// closed form have no ends.
  Projection<D> project(const Vec<D>& x, const Projection<D>& seed, FacePoint<D>& point) const;
  /// Outward unit normal at a closest point that is no corner.
  Vec<D> normal(const FacePoint<D>& point) const;
  /// How much of a traction acts at a closest point, with its derivatives: less than 1 beyond an open end.
  double fade(const FaceCoordinates<D>& xi, FaceCoordinates<D>& rate) const;
  /// The functions at point.element, point.xi, with first derivatives when `order` is 1.
  void functions(FacePoint<D>& point, int order) const;
  /// Geometry of order 0 and functions without derivatives at a coordinate, and the element it lies in.
  void locate(const FaceCoordinates<D>& xi, FacePoint<D>& point) const;
  /// The slip point's coordinate after a step (slip.hpp); `foot` as projected.
  FaceCoordinates<D> advance(const FaceCoordinates<D>& slip, const FacePoint<D>& foot, double length) const;

private:
  void place(FacePoint<D>& point) const;

  bool rigid_;
  std::optional<Obstacle<D>> shape_; ///< in closed form
  std::optional<Surface<D>> surface_;
  ElementBoxes<D> boxes_;
  Vec<D> translation_ = Vec<D>::Zero();               ///< of a rigid master
  Eigen::Matrix<double, D, Eigen::Dynamic> previous_; ///< control points before the last move
  std::vector<double> displacements_;                 ///< working space: a rigid face's, all alike
};

} // namespace signorini::contact
