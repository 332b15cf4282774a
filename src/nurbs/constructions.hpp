#pragma once
// Surfaces and volumes made of curves and surfaces.

#include "nurbs/transform.hpp"

namespace signorini::nurbs {

/// One parametric direction of a patch.
struct Along {
  Patch* patch;
  int direction;
};

/// Brings the directions to one degree and one knot vector, on the first one's interval; the maps keep their images.
void unify(const std::vector<Along>& directions);

/// Ruled patch between two of equal parametric dimension (brought to common degrees and knots first); new last
/// direction of degree 1 from a to b.
Patch ruled(const Patch& a, const Patch& b);
/// Sweeps along a vector; new last direction of degree 1. The result has the dimension of `along`: a plane patch swept
/// along a vector of 3 coordinates starts at z = 0.
Patch extrude(const Patch& patch, const Point& along);
/// Revolves a 3D curve or surface by `angle` degrees (right-handed, at most a full turn) about the axis through `point`
/// along `axis`; new last direction, quadratic, knots as for an arc.
Patch revolve(const Patch& patch, const Point& point, const Point& axis, double angle);
/// Bilinearly blended Coons surface of four boundary curves in the order west, east, south, north, or the trilinear
/// Coons volume of six boundary surfaces (then front, back), each running in its directions' order: west and east along
/// ξ² (and ξ³), south and north along ξ¹ (and ξ³), front and back along ξ¹ and ξ². The boundary is kept exactly. Throws
/// Error when curves or surfaces do not meet to 1e-9 of the size, or meet with different weights.
Patch coons(const std::vector<Patch>& boundary);

} // namespace signorini::nurbs
