#pragma once
// Master side of a contact: the moving face of a body, or a rigid obstacle.

#include "contact/closest/projection.hpp"
#include "contact/rigid/obstacle.hpp"
#include "contact/rigid/rigid_motion.hpp"

namespace signorini::contact {

/// Position, kinematics and functions of a master. A face has the functions of its body, a rigid one those of
/// RigidMotion.
///
/// If the traction ended with the face, it would jump whenever a point passes the end, where for example the edge of a
/// block pressed into a slab carries most load; and a point at a plane of symmetry that rounding error or a small slope
/// of the face projects beyond the end would lose contact. Therefore the face is extended by a fraction of its last
/// element or, if that is smaller, of the slave's elements, and the traction fades to zero there. The slave's elements
/// matter because a master may be one element long, like many rigid curves.
template <int D> class Master {
public:
  /// `opposite`: size of the slave's elements in the reference configuration.
  Master(Surface<D> face, double opposite = std::numeric_limits<double>::infinity());
  /// A set of faces, a sheet of `face` each.
  Master(Surface<D> face, double opposite, SetParts parts);
  Master(Obstacle<D> obstacle, std::optional<Turning<D>> turning = {},
         double opposite = std::numeric_limits<double>::infinity());

  bool rigid() const { return rigid_; }
  /// The moving face, or the rigid NURBS curve or surface; null for a closed-form shape.
  const Surface<D>* surface() const { return surface_ ? &*surface_ : nullptr; }
  /// Null unless a set.
  const FaceSet<D>* set() const { return set_.get(); }
  /// Number of functions on an element; the number of nodes when rigid.
  int functions_on(int element) const { return rigid_ ? motion_.nodes() : surface_->functions_on(element); }
  /// Largest number of functions on an element.
  int most_functions() const { return rigid_ ? motion_.nodes() : surface_->most_functions(); }

  /// Sets displacements, D values per function of the body, or per node of the obstacle. Returns an upper bound of the
  /// distance by which any point has come closer to the convex hull of `opposite` (D × points).
  double move(const double* displacement, const PointColumns<D>& opposite = {});
  /// The bound of move() between another position of the master and this one.
  double moved_since(const Master& before, const PointColumns<D>& opposite) const;

  /// The closest point to x, see projection.hpp; `point` receives the geometry there (order 2) without functions.
  /// Closed-form shapes have no ends. `from`: of a set, see lookout().
  Projection<D> project(const Vec<D>& x, const Projection<D>& seed, FaceGeometry<D>& point,
                        const Lookout<D>& from = {}) const;
  /// The boxes of a face's elements.
  const ElementBoxes<D>& boxes() const { return boxes_; }
  /// Of a set, see ElementBoxes.
  void note_motion(const Master& accepted) { boxes_.note_motion(*accepted.surface_, *surface_); }
  /// True only if project() would find an open end; a quick test, which many points beyond an end pass.
  bool is_beyond_ends(const Vec<D>& x) const { return boxes_.is_beyond_ends(x); }
  /// Outward unit normal at a closest point other than a corner.
  Vec<D> normal(const FaceGeometry<D>& point) const;
  /// Factor on the traction at a closest point, below 1 beyond an open end; `rate` receives its derivatives.
  double fade(const FaceCoordinates<D>& xi, FaceCoordinates<D>& rate) const;
  /// Evaluates the functions at point.element, point.xi, with first derivatives if `order` is 1.
  void functions(FacePoint<D>& point, int order) const;
  /// Sets the element that contains a point, the position and the functions there, without derivatives.
  void locate(const MasterPoint<D>& at, FacePoint<D>& point) const;
  /// The geometry (order 2) at a closest point found before, without functions.
  void locate(const Projection<D>& projection, FaceGeometry<D>& point) const;
  /// The slip point after a step (slip.hpp); `foot` is the projected point.
  MasterPoint<D> advance(const MasterPoint<D>& slip, const FaceGeometry<D>& foot, double length) const;
  /// The point on the line through a goal along a normal, searched from a closest point.
  MasterPoint<D> along_normal(const Vec<D>& goal, const Vec<D>& normal, Projection<D> closest,
                              const Lookout<D>& from = {}) const;

private:
  void place(FaceGeometry<D>& point) const;

  bool rigid_;
  std::optional<Obstacle<D>> shape_; ///< a closed-form shape
  std::optional<Surface<D>> surface_;
  ElementBoxes<D> boxes_;
  RigidMotion<D> motion_; ///< of a rigid master
  std::shared_ptr<const FaceSet<D>> set_;
};

} // namespace signorini::contact
