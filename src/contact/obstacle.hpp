#pragma once
// Rigid obstacles: shapes without unknowns, with closest points in closed form where there is one.

#include "contact/surface.hpp"

#include <variant>

namespace signorini::contact {

/// A half space; the normal points out of it. In the plane ξ is the length along the line from `point`, in space two
/// lengths at right angles.
template <int D> struct Plane { Vec<D> point, normal; };

/// A ball; in the plane a disc: the section of a cylinder, or of a sphere about the axis. In the plane ξ is the angle,
/// in space azimuth and polar angle.
template <int D> struct Ball {
  Vec<D> center;
  double radius;
};

/// An endless cylinder; ξ is the angle about the axis (a unit vector) and the length along it.
struct Cylinder {
  Vec<3> point, axis;
  double radius;
};

/// A rigid body as a slave face meets it. A patch is a curve in the plane with its outside on the right of its
/// direction, or a surface with its outside where τ₁×τ₂ points.
template <int D>
using Obstacle = std::conditional_t<D == 2, std::variant<Plane<D>, Ball<D>, nurbs::Patch>,
                                    std::variant<Plane<D>, Ball<D>, Cylinder, nurbs::Patch>>;

/// With the normal made a unit vector. Throws Error when it is zero or anything is not finite.
template <int D> Plane<D> make_plane(const Vec<D>& point, const Vec<D>& normal);
/// Throws Error unless the radius is a positive number.
template <int D> Ball<D> make_ball(const Vec<D>& center, double radius);
/// With the axis made a unit vector. Throws Error when it is zero, or unless the radius is a positive number.
Cylinder make_cylinder(const Vec<3>& point, const Vec<3>& axis, double radius);

/// Largest coordinate that enters a closest point: of its points or center, with the radius.
template <int D> double largest_coordinate(const Obstacle<D>& obstacle);

/// Coordinate of the point of the shape that is closest to x, both without the obstacle's translation.
template <int D> FaceCoordinates<D> closest(const Plane<D>& plane, const Vec<D>& x);
FaceCoordinates<2> closest(const Ball<2>& ball, const Vec<2>& x);
FaceCoordinates<3> closest(const Ball<3>& ball, const Vec<3>& x);
FaceCoordinates<3> closest(const Cylinder& cylinder, const Vec<3>& x);
/// Position, tangents and second derivatives at point.xi; in the plane the tangent turned by −90° points outward, in
/// space τ₁×τ₂. Those of a ball belong to coordinates of its own there, so that poles are points like others.
template <int D> void locate(const Plane<D>& plane, FacePoint<D>& point);
void locate(const Ball<2>& ball, FacePoint<2>& point);
void locate(const Ball<3>& ball, FacePoint<3>& point);
void locate(const Cylinder& cylinder, FacePoint<3>& point);
/// The coordinate on the shortest way between `slip` and `foot` whose point has the given distance from that of `foot`,
/// of which xi alone counts.
FaceCoordinates<2> advance_slip(const Plane<2>&, const FaceCoordinates<2>& slip, const FacePoint<2>& foot,
                                double length);
FaceCoordinates<2> advance_slip(const Ball<2>&, const FaceCoordinates<2>& slip, const FacePoint<2>& foot,
                                double length);
FaceCoordinates<3> advance_slip(const Plane<3>&, const FaceCoordinates<3>& slip, const FacePoint<3>& foot,
                                double length);
FaceCoordinates<3> advance_slip(const Ball<3>&, const FaceCoordinates<3>& slip, const FacePoint<3>& foot,
                                double length);
FaceCoordinates<3> advance_slip(const Cylinder&, const FaceCoordinates<3>& slip, const FacePoint<3>& foot,
                                double length);

} // namespace signorini::contact
