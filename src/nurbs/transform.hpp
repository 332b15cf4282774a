#pragma once
// Affine maps of a whole patch: they act on the control points alone.

#include "nurbs/patch.hpp"

namespace signorini::nurbs {

using Point = VectorX; ///< 2 or 3 coordinates

/// x ↦ linear·x + shift for every point; a 3 × 2 `linear` carries a plane patch into space.
Patch transform(const Patch& patch, const MatrixX& linear, const VectorX& shift);

/// Moves every point by the vector `by`.
Patch translate(const Patch& patch, const Point& by);
/// Rotation by `angle` degrees, counter-clockwise: about `center` in 2D (`axis` stays empty), about the axis through
/// `center` along `axis` (any length) in 3D.
Patch rotate(const Patch& patch, double angle, const Point& center, const Point& axis = {});
/// Scales by one factor per coordinate about `center`. Throws Error for a factor that is not positive.
Patch scale(const Patch& patch, const Point& factors, const Point& center);
/// Reflects every point in the plane (in 2D: the line) through `point` across `normal` (any length but 0). Surfaces in
/// the plane, volumes, and what may bound an obstacle (a curve in the plane, a surface in space) have their direction
/// that runs most along the normal reversed, the first of several: so right-handed stays right-handed, outside stays
/// outside, and on a patch along the axes the names of faces keep their sides.
Patch mirror(const Patch& patch, const Point& point, const Point& normal);

/// A curve or surface in the plane as one in space, at one z. Throws Error for a patch that is in space already.
Patch to_space(const Patch& patch, double z = 0);
/// A curve or surface in space whose z is the same everywhere, but for rounding, as one in the plane. Throws Error
/// where it is not, and for volumes; a patch in the plane stays as it is.
Patch to_plane(const Patch& patch);

/// Throws Error unless `point`, the argument `name`, has `dimension` finite coordinates.
void check_point(const char* name, const Point& point, int dimension);
/// (cos, sin) of an angle in degrees, exact at quarter turns.
Eigen::Vector2d direction_of(double degrees);
/// The matrix of a rotation by `angle` degrees about `axis` (3 coordinates, any length but 0) through the origin.
Mat<3> rotation(double angle, const Point& axis);

} // namespace signorini::nurbs
