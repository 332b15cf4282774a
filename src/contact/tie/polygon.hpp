#pragma once
// Polygons in the parameter plane: their intersection with a box, and Gauss quadrature on them.

#include "solid/quadrature.hpp"

#include <array>
#include <vector>

namespace signorini::contact {

using Polygon = std::vector<Vec<2>>;

/// The part of a polygon inside the box lower … upper (I. E. Sutherland, G. W. Hodgman, CACM 17, 1974).
Polygon clip(const Polygon& polygon, const Vec<2>& lower, const Vec<2>& upper);
double area(const Polygon& polygon);
/// Exact for polynomials up to `degree` in each direction on a convex polygon: Gauss points on a rectangle along the
/// axes, otherwise on triangles, collapsed from squares.
solid::ElementQuadrature quadrature(const Polygon& polygon, int degree);

} // namespace signorini::contact
