#pragma once
// Rigid obstacles: shapes without unknowns, with closest points in closed form where there is one.

#include "contact/surface.hpp"

#include <variant>

namespace signorini::contact {

/// A half space; the normal points out of it. In the plane ξ is the length along the line from `point`.
template <int D> struct Plane { Vec<D> point, normal; };

/// A ball; in the plane a disc: the section of a cylinder, or of a sphere about the axis. In the plane ξ is the angle.
template <int D> struct Ball {
  Vec<D> centre;
  double radius;
};

/// A rigid body as a slave face meets it. A patch (a curve in the plane) has its outside on the right of its direction.
template <int D> using Obstacle = std::variant<Plane<D>, Ball<D>, nurbs::Patch>;

/// With the normal made a unit vector. Throws Error when it is zero or anything is not finite.
template <int D> Plane<D> make_plane(const Vec<D>& point, const Vec<D>& normal);
/// Throws Error unless the radius is a positive number.
template <int D> Ball<D> make_ball(const Vec<D>& centre, double radius);

/// Coordinate of the point of the shape that is closest to x, both without the obstacle's translation.
double closest(const Plane<2>& plane, const Vec<2>& x);
double closest(const Ball<2>& ball, const Vec<2>& x);
/// Position, tangent and second derivative at point.xi; the tangent turned by −90° points outward.
void locate(const Plane<2>& plane, FacePoint<2>& point);
void locate(const Ball<2>& ball, FacePoint<2>& point);
/// The coordinate between `slip` and `foot` whose point has the given distance from that of `foot`.
double advance_slip(const Plane<2>& plane, double slip, double foot, double length);
double advance_slip(const Ball<2>& ball, double slip, double foot, double length);

} // namespace signorini::contact
