#pragma once
// Loads: dead ones, of which size and direction refer to the reference configuration, and the pressure that follows.

#include "solid/face_points.hpp"

namespace signorini::solid {

/// f_A = ∫ R_A dA e_component over the reference area of a face: the nodal forces of a unit traction. D values per
/// control point of the body; per unit depth in plane strain, over the full circle for a body of revolution. The side
/// may cross layers. Throws Error for a component that is not in 0 … D−1.
template <int D> VectorX traction_load(const Body<D>& body, nurbs::Side side, int component);

/// f_A = −∫ R_A N dA with the outward normal N of the reference configuration: the nodal forces of a unit pressure as a
/// dead load, whose direction does not follow the deformation. Otherwise as traction_load().
template <int D> VectorX pressure_load(const Body<D>& body, nurbs::Side side);

/// f_A = ∫ R_A dV e_component over the reference volume: the nodal forces of a unit force per volume.
template <int D> VectorX body_load(const Body<D>& body, int component);

/// The number of Gauss points of a face.
template <int D> Eigen::Index face_point_count(const Body<D>& body, nurbs::Side side);

/// Gauss points of a face or a body: reference positions, D × points, and the reference areas or volumes for which they
/// stand. With `times` left out those of loads, otherwise of another rule, see face_points() and element_quadrature().
struct LoadPoints {
  MatrixX positions;
  VectorX measures;
};
template <int D> LoadPoints load_points(const Body<D>& body, nurbs::Side side, int times = 2);
template <int D> LoadPoints load_points(const Body<D>& body, int times = 1);

/// The nodal forces of a dead load with given values at these points: tractions or forces per volume, D × points, or
/// pressures on a face, 1 × points.
template <int D> VectorX distributed_load(const Body<D>& body, nurbs::Side side, const MatrixX& values);
template <int D> VectorX distributed_load(const Body<D>& body, const MatrixX& values);

/// ∫ R_A dL along the edge of a solid where two sides meet, in the reference configuration, per function.
VectorX edge_lengths(const Body<3>& body, nurbs::Side first, nurbs::Side second);

/// f_A = −∫ R_A n da over the current surface of a part of a face, with the positions x of its functions' control
/// points, D × functions: the nodal forces, in the same order, of a unit pressure that follows the deformation. Under
/// plane stress the surface has the undeformed thickness.
template <int D> MatrixX follower_load(const FacePoints<D>& part, const MatrixX& x);

/// Its derivative ∂f_A/∂x_B, with D rows and columns per function. Not symmetric: its skew part sums to an integral
/// along the borders of the face [theory 3.5].
template <int D> MatrixX follower_tangent(const FacePoints<D>& part, const MatrixX& x);

} // namespace signorini::solid
