#pragma once
// Rigid motion of an obstacle: a translation, and a rotation about a point that moves with it [theory 6.2].

#include "contact/face/surface.hpp"

#include <optional>

namespace signorini::contact {

/// Rotation of a rigid master. `arm` is the length L that makes the displacements of its markers lengths: of the size
/// of the shape, so that forces on markers and on the translation compare.
template <int D> struct Turning {
  Vec<D> center;
  double arm;
};

/// Points as columns.
template <int D> using PointColumns = Eigen::Matrix<double, D, Eigen::Dynamic>;

/// A single node, its translation t, whose shape function is 1 everywhere, so that the same residual and tangent serve
/// bodies and obstacles. An obstacle that turns about c has D further nodes, the markers c + L e_i, e_i the unit
/// vectors. With their displacements u_i = L (R − I) e_i relative to t, its points are at
///     x = X + t + Σ_i N_i u_i,   N_i = (X − c)·e_i / L,
/// linear in the nodes like the points of a face.
template <int D> class RigidMotion {
public:
  explicit RigidMotion(std::optional<Turning<D>> turning = {}) : turning_(std::move(turning)) {}

  int nodes() const { return turning_ ? 1 + D : 1; }
  /// Sets displacements of the nodes. Returns a bound as of Master::move().
  double move(const double* displacement, const PointColumns<D>& opposite);
  double moved_since(const RigidMotion& before, const PointColumns<D>& opposite) const;
  /// x as seen from an obstacle that neither moves nor turns.
  Vec<D> pulled_back(const Vec<D>& x) const;
  /// Moves a point of an obstacle that neither moves nor turns, with its tangents and second derivatives.
  void place(FaceGeometry<D>& point) const;
  /// Displacements of points.
  PointColumns<D> displacements(const PointColumns<D>& points) const;
  /// Evaluates the functions of the nodes at a point, with first derivatives if `order` is 1.
  void functions(FacePoint<D>& point, int order) const;

private:
  double turned(const Mat<D>& before, const PointColumns<D>& opposite) const;

  Vec<D> translation_ = Vec<D>::Zero();
  std::optional<Turning<D>> turning_;
  Mat<D> turn_ = Mat<D>::Zero(); ///< R − I, without rounding errors of R far from the center
};

} // namespace signorini::contact
