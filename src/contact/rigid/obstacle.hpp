#pragma once
// Rigid obstacles: shapes without unknowns, with closed-form closest points except for NURBS patches and level sets
// [theory 6.1].

#include "contact/rigid/level_set.hpp"

#include <variant>

namespace signorini::contact {

/// A half space with outward normal. ξ is the length along the line from its point closest to the origin (2D), or two
/// lengths in orthogonal directions (3D).
template <int D> struct Plane { Vec<D> point, normal; };

/// A ball; in 2D a disc: the section of a cylinder, of a sphere centered on the axis of revolution, or of a torus. ξ is
/// the angle from the near point (near_point.hpp), of a hollow one clockwise (2D), or azimuth and polar angle about it
/// (3D). Hollow shapes surround the body.
template <int D> struct Ball {
  Vec<D> center;
  double radius;
  bool hollow = false;
};

/// An infinite cylinder; ξ is the angle about the axis (a unit vector) and the length along it, from the near point.
struct Cylinder {
  Vec<3> point, axis;
  double radius;
  bool hollow = false;
};

/// A circle of `radius`, its center on a ring about the axis (a unit vector), revolved; ξ are the angles about the axis
/// and along the circle, from the near point.
struct Torus {
  Vec<3> center, axis;
  double ring, radius;
  bool hollow = false;
};

/// Shape of a rigid obstacle. A patch is a curve with the outside on the right of its direction (2D), or a surface
/// whose outward normal is τ₁×τ₂ (3D).
template <int D>
using Obstacle = std::conditional_t<D == 2, std::variant<Plane<D>, Ball<D>, nurbs::Patch, LevelSet<D>>,
                                    std::variant<Plane<D>, Ball<D>, Cylinder, nurbs::Patch, LevelSet<D>, Torus>>;

/// Normalizes the normal. Throws Error if it is zero or any value is not finite.
template <int D> Plane<D> make_plane(const Vec<D>& point, const Vec<D>& normal);
/// Throws Error unless the radius is a positive number.
template <int D> Ball<D> make_ball(const Vec<D>& center, double radius, bool hollow = false);
/// Normalizes the axis. Throws Error if it is zero, or unless the radius is a positive number.
Cylinder make_cylinder(const Vec<3>& point, const Vec<3>& axis, double radius, bool hollow = false);
/// Normalizes the axis. Throws Error if it is zero, or unless 0 < radius < ring.
Torus make_torus(const Vec<3>& center, const Vec<3>& axis, double ring, double radius, bool hollow = false);

/// Coordinate of the point of the shape closest to x, both without the obstacle's translation.
template <int D> FaceCoordinates<D> closest(const Plane<D>& plane, const Vec<D>& x);
FaceCoordinates<2> closest(const Ball<2>& ball, const Vec<2>& x);
FaceCoordinates<3> closest(const Ball<3>& ball, const Vec<3>& x);
FaceCoordinates<3> closest(const Cylinder& cylinder, const Vec<3>& x);
FaceCoordinates<3> closest(const Torus& torus, const Vec<3>& x);
/// Writes these coordinates to `point`, as for level sets.
template <class Shape, int D> void find_closest(const Shape& shape, const Vec<D>& x, FaceGeometry<D>& point) {
  point.xi = closest(shape, x);
}
/// Position, tangents and second derivatives at point.xi. The outward direction is the tangent rotated by −90° (2D) or
/// τ₁×τ₂ (3D). On a ball in 3D they refer to local angles at the point, so that poles are regular. Hollow shapes in 3D
/// exchange the two tangents.
template <int D> void locate(const Plane<D>& plane, FaceGeometry<D>& point);
void locate(const Ball<2>& ball, FaceGeometry<2>& point);
void locate(const Ball<3>& ball, FaceGeometry<3>& point);
void locate(const Cylinder& cylinder, FaceGeometry<3>& point);
void locate(const Torus& torus, FaceGeometry<3>& point);
/// The coordinate on the shortest path from `foot` to `slip` whose point is at distance `length` from that of `foot`,
/// of which only xi is used. On a torus the path is the projection of the chord or, across the tube, straight in both
/// angles.
FaceCoordinates<2> advance_slip(const Plane<2>&, const FaceCoordinates<2>& slip, const FaceGeometry<2>& foot,
                                double length);
FaceCoordinates<2> advance_slip(const Ball<2>&, const FaceCoordinates<2>& slip, const FaceGeometry<2>& foot,
                                double length);
FaceCoordinates<3> advance_slip(const Plane<3>&, const FaceCoordinates<3>& slip, const FaceGeometry<3>& foot,
                                double length);
FaceCoordinates<3> advance_slip(const Ball<3>&, const FaceCoordinates<3>& slip, const FaceGeometry<3>& foot,
                                double length);
FaceCoordinates<3> advance_slip(const Cylinder&, const FaceCoordinates<3>& slip, const FaceGeometry<3>& foot,
                                double length);
FaceCoordinates<3> advance_slip(const Torus&, const FaceCoordinates<3>& slip, const FaceGeometry<3>& foot,
                                double length);

} // namespace signorini::contact
