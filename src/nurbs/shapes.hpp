#pragma once
// Ready-made patches: curves, constructions from curves and surfaces, and the bodies of the published problems.
// Everything is exact at the lowest degree that can be, except where a docstring says otherwise.

#include "nurbs/patch.hpp"

#include <array>

namespace signorini::nurbs {

using Point = VectorX; ///< 2 or 3 coordinates

/// Straight line, degree 1.
Patch line(const Point& from, const Point& to);
/// Circular arc in the plane (2D, or 3D at z = centre z) from angle `start` to `stop` (degrees, counter-clockwise when
/// rising), quadratic, one segment per started quarter turn with C⁰ knots between them at equal knot spacing.
Patch arc(const Point& centre, double radius, double start, double stop);
/// Full circle: four quarter arcs.
Patch circle(const Point& centre, double radius);
/// Ruled patch between two of equal parametric dimension (brought to common degrees and knots first); new last direction.
Patch ruled(const Patch& a, const Patch& b);
/// Sweeps along a vector; new last direction of degree 1. The result has the dimension of `along`.
Patch extrude(const Patch& patch, const Point& along);
/// Revolves a 3D curve or surface by `angle` degrees about the axis through `point` along `axis`; new last direction.
Patch revolve(const Patch& patch, const Point& point, const Point& axis, double angle);
/// Bilinearly blended Coons surface of four boundary curves, or the trilinear Coons volume of six boundary surfaces in
/// the order west, east, south, north(, front, back); corners must meet to 1e-9 of the size. Throws Error when weights
/// along shared corners differ.
Patch coons(const std::vector<Patch>& boundary);

/// Rectangle [corner, corner + (width, height)], bilinear.
Patch rectangle(double width, double height, const Point& corner);
/// Half annulus below its centre: ξ¹ along the arc from the left end over the bottom to the right end (two quarter arcs,
/// C⁰ knot), ξ² from the outer (south) to the inner radius (north), linear.
Patch half_annulus(double inner, double outer, const Point& centre);
/// Quarter annulus from angle `start` (degrees) counter-clockwise by 90°: ξ¹ along the arc, ξ² from outer to inner.
Patch quarter_annulus(double inner, double outer, const Point& centre, double start);
/// Block [corner, corner + size], trilinear; ξ¹ξ²ξ³ along x, y, z.
Patch block(const std::array<double, 3>& size, const Point& corner);
/// Half-cylinder shell, its axis along y: the half annulus in the x-z plane extruded by `width`; ξ¹ along the arc,
/// ξ² along y, ξ³ from the outer (front) to the inner radius (back).
Patch half_cylinder_shell(double inner, double outer, double width, const Point& centre);
/// Octant of a hollow sphere, lower: ξ¹ around the z axis, ξ² from the equator to the pole (degenerate edge), ξ³ from the
/// outer (front) to the inner radius (back).
Patch sphere_octant(double inner, double outer, const Point& centre);
/// Block-like indenter of width × depth with flat top; its bottom (front, ξ³ = 0) is a spherical cap of radius `radius`
/// that bulges downwards, lowest at the middle: a biquadratic patch that interpolates the sphere's heights at the
/// Greville points of `elements` × `elements` spans. `corner`: x, y of the corner, z of the cap's lowest point;
/// height from there to the top.
Patch spherical_indenter(double width, double depth, double height, double radius, int elements, const Point& corner);

/// Rigid motions and scaling of a whole patch.
Patch translate(const Patch& patch, const Point& by);
/// Rotation by degrees about `centre` (2D), or about the axis through `centre` along `axis` (3D).
Patch rotate(const Patch& patch, double angle, const Point& centre, const Point& axis);
/// Scales by one factor per coordinate about `centre`. Throws Error for a factor that is not positive.
Patch scale(const Patch& patch, const Point& factors, const Point& centre);

} // namespace signorini::nurbs
