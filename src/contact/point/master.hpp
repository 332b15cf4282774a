#pragma once
// Master side of a contact: the moving face of a body, or a rigid obstacle.

#include "contact/closest/projection.hpp"
#include "contact/rigid/obstacle.hpp"

namespace signorini::contact {

/// Rotation of a rigid master about a point that moves with it. `arm` is the length L that makes the displacements of
/// its markers lengths: of the size of the shape, so that forces on markers and on the translation compare.
template <int D> struct Turning {
  Vec<D> center;
  double arm;
};

/// Position, kinematics and functions of a master. A rigid one has a single node, its translation t, whose shape
/// function is 1 everywhere, so that the same residual and tangent serve both. One that turns about c has D further
/// nodes, the markers c + L e_i, e_i the unit vectors. With their displacements u_i = L (R − I) e_i relative to t, its
/// points are at
///     x = X + t + Σ_i N_i u_i,   N_i = (X − c)·e_i / L,
/// linear in the nodes like the points of a face.
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
  Master(Obstacle<D> obstacle, std::optional<Turning<D>> turning = {},
         double opposite = std::numeric_limits<double>::infinity());

  bool rigid() const { return rigid_; }
  /// The moving face, or the rigid NURBS curve or surface; null for a closed-form shape.
  const Surface<D>* surface() const { return surface_ ? &*surface_ : nullptr; }
  /// Number of functions on an element; the number of nodes when rigid.
  int functions_on(int element) const { return rigid_ ? nodes() : surface_->functions_on(element); }
  /// Largest number of functions on an element.
  int most_functions() const { return rigid_ ? nodes() : surface_->most_functions(); }

  /// Sets displacements, D values per function of the body, or per node of the obstacle. Returns an upper bound of the
  /// distance by which any point has come closer to the convex hull of `opposite` (D × points).
  double move(const double* displacement, const Eigen::Matrix<double, D, Eigen::Dynamic>& opposite = {});
  /// The same bound between another position of the master and this one.
  double moved_since(const Master& before, const Eigen::Matrix<double, D, Eigen::Dynamic>& opposite) const;

  /// The closest point to x, see projection.hpp; `point` receives the geometry there (order 2) without functions.
  /// Closed-form shapes have no ends.
  Projection<D> project(const Vec<D>& x, const Projection<D>& seed, FaceGeometry<D>& point) const;
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

private:
  int nodes() const { return turning_ ? 1 + D : 1; }
  void place(FaceGeometry<D>& point) const;
  double turned(const Mat<D>& before, const Eigen::Matrix<double, D, Eigen::Dynamic>& opposite) const;
  Vec<D> pulled_back(const Vec<D>& x) const;

  bool rigid_;
  std::optional<Obstacle<D>> shape_; ///< a closed-form shape
  std::optional<Surface<D>> surface_;
  ElementBoxes<D> boxes_;
  Vec<D> translation_ = Vec<D>::Zero(); ///< of a rigid master
  std::optional<Turning<D>> turning_;
  Mat<D> turn_ = Mat<D>::Zero();      ///< R − I, without rounding errors of R far from the center
  std::vector<double> displacements_; ///< working space: of the control points of a rigid face
};

} // namespace signorini::contact
