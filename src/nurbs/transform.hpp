#pragma once
// Affine maps of a patch, applied to the control points.

#include "nurbs/patch.hpp"

namespace signorini::nurbs {

using Point = VectorX; ///< 2 or 3 coordinates

/// x ↦ linear·x + shift for every point; a 3 × 2 `linear` maps a plane patch into space.
Patch transform(const Patch& patch, const MatrixX& linear, const VectorX& shift);

/// Moves every point by the vector `by`.
Patch translate(const Patch& patch, const Point& by);
/// Rotation by `angle` degrees, counter-clockwise: about `center` in 2D (`axis` stays empty), about the axis through
/// `center` along `axis` (any nonzero length) in 3D.
Patch rotate(const Patch& patch, double angle, const Point& center, const Point& axis = {});
/// Scales by one factor per coordinate about `center`. Throws Error for a factor that is not positive.
Patch scale(const Patch& patch, const Point& factors, const Point& center);
/// Reflects every point in the plane (in 2D: the line) through `point` with `normal` (any nonzero length). In surfaces
/// in the plane, volumes, and boundaries of obstacles (curves in the plane, surfaces in space) the direction closest to
/// the normal, the first of several, is reversed: a right-handed patch stays right-handed, the outside stays outside,
/// and on a patch along the axes the names of faces keep their sides.
Patch mirror(const Patch& patch, const Point& point, const Point& normal);

/// A plane curve or surface in space, at one z. Throws Error for a patch that is in space already.
Patch to_space(const Patch& patch, double z = 0);
/// A curve or surface in space of constant z (within rounding error) as one in the plane. Throws Error if z varies, and
/// for volumes; a plane patch is returned unchanged.
Patch to_plane(const Patch& patch);

/// Throws Error unless `point`, the argument `name`, has `dimension` finite coordinates.
void check_point(const char* name, const Point& point, int dimension);
/// (cos, sin) of an angle in degrees, exact at quarter turns.
Eigen::Vector2d direction_of(double degrees);
/// The matrix of a rotation by `angle` degrees about `axis` (3 coordinates, any nonzero length) through the origin.
Mat<3> rotation(double angle, const Point& axis);

} // namespace signorini::nurbs
