#pragma once
// Predefined patches: the bodies of the published problems. All are exact and of the lowest possible degree unless
// stated otherwise.

#include "nurbs/constructions.hpp"
#include "nurbs/curves.hpp"
#include "nurbs/transform.hpp"

#include <array>

namespace signorini::nurbs {

/// Rectangle [corner, corner + (width, height)], bilinear.
Patch rectangle(double width, double height, const Point& corner);
/// Half annulus below its center: ξ¹ along the arc from the left end over the bottom to the right end (two quarter
/// arcs, C⁰ knot), ξ² from the outer (south) to the inner radius (north), linear.
Patch half_annulus(double inner, double outer, const Point& center);
/// Quarter annulus from angle `start` (degrees) counter-clockwise by 90°: ξ¹ along the arc, ξ² from outer to inner.
Patch quarter_annulus(double inner, double outer, const Point& center, double start);
/// Ring: ξ¹ once around, counter-clockwise from the highest point (west and east are the two sides of a seam), ξ² from
/// the outer (south) to the inner radius (north).
Patch ring(double inner, double outer, const Point& center);
/// Disc of one patch: ξ¹ as the ring's, ξ² from the circle (south) to the center, to which north is collapsed.
Patch polar_disc(double radius, const Point& center);
/// Snap-fit hook: a beam of `length` × `thickness` from `corner` along x with a nose on its upper side that rises by
/// `nose` under the angle `retention` (degrees, 90 is upright), continues for `land` and falls to the tip under the
/// angle `insertion`. Bilinear with three C⁰ knots; ξ¹ along x, ξ² along y.
Patch hook(double length, double thickness, double nose, double land, double insertion, double retention,
           const Point& corner);
/// Block [corner, corner + size], trilinear; ξ¹ξ²ξ³ along x, y, z.
Patch block(const std::array<double, 3>& size, const Point& corner);
/// Half-cylinder shell with its axis along y from `center` to `center` + (0, width, 0): the half annulus in the x-z
/// plane, below its axis, extruded; ξ¹ along the arc, ξ² along y, ξ³ from the outer (front) to the inner radius (back).
Patch half_cylinder_shell(double inner, double outer, double width, const Point& center);
/// Pipe along y: the ring in the x-z plane, extruded; ξ¹ once around from the highest line (west and east are the two
/// sides of a seam), ξ² along y, ξ³ from the outer (front) to the inner radius (back).
Patch tube(double inner, double outer, double width, const Point& center);
/// Cylinder along y of one patch: ξ¹ and ξ² as the tube's, ξ³ from the circle (front) to the axis, to which back is
/// collapsed.
Patch polar_cylinder(double radius, double width, const Point& center);
/// Ball of one patch: ξ¹ once around the z axis from x over y (west and east are the two sides of a seam), ξ² from the
/// upper to the lower pole (south and north are collapsed to half the axis each), ξ³ from the sphere (front) to the
/// center, to which back is collapsed.
Patch polar_ball(double radius, const Point& center);
/// Octant x, y ≥ 0, z ≤ 0 of a hollow sphere about `center`: ξ¹ around the z axis from x to y, ξ² from the equator to
/// the lower pole (degenerate edge), ξ³ from the outer (front) to the inner radius (back).
Patch sphere_octant(double inner, double outer, const Point& center);
/// Position of a hemisphere's poles, which are degenerate edges.
enum class Poles {
  ends,  ///< two, at both ends of the ring's diameter along y: none at the contact with a plane below
  bottom ///< one, at the lowest point; the ring is one face, the mesh has rotational symmetry about z
};
/// Lower half of a hollow sphere about `center`, ξ³ from the outer (front) to the inner radius (back).
/// Poles::ends: ξ¹ from −x over the bottom to x, ξ² from the pole at −y to that at y (south and north are collapsed to
/// a line each), two quarter arcs in both directions; the flat ring on top is west (x ≤ 0) and east (x ≥ 0).
/// Poles::bottom: ξ¹ once around the z axis from x over y (four quarter arcs; west and east are the two sides of a
/// seam), ξ² from the flat ring (south) down to the pole (north is collapsed to a line).
/// coincident_functions() returns the control points that coincide.
Patch hollow_hemisphere(double inner, double outer, const Point& center, Poles poles);
/// Block-like indenter of width × depth with a flat top; its bottom (front, ξ³ = 0) is a spherical cap of radius
/// `radius` that bulges downwards, lowest in the middle: a biquadratic patch that interpolates the sphere's heights at
/// the Greville points of `elements` × `elements` spans and is approximate between them. `corner`: x, y of the corner,
/// z of the cap's lowest point; `height`: from that point to the top.
Patch spherical_indenter(double width, double depth, double height, double radius, int elements, const Point& corner);

} // namespace signorini::nurbs
