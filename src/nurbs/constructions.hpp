#pragma once
// Surfaces and volumes made from curves and surfaces.

#include "nurbs/transform.hpp"

namespace signorini::nurbs {

/// One parametric direction of a patch.
struct Along {
  Patch* patch;
  int direction;
};

/// Raises the directions to a common degree and refines them to a common knot vector on the first one's interval; the
/// images of the maps stay the same.
void unify(const std::vector<Along>& directions);

/// Ruled patch between two patches of equal parametric dimension (brought to common degrees and knots first); the new
/// last direction has degree 1 and runs from a to b.
Patch ruled(const Patch& a, const Patch& b);
/// Sweeps along a vector; the new last direction has degree 1. The result has the dimension of `along`: a plane patch
/// swept along a vector of 3 coordinates starts at z = 0.
Patch extrude(const Patch& patch, const Point& along);
/// Revolves a 3D curve or surface by `angle` degrees (right-handed, at most a full revolution) about the axis through
/// `point` along `axis`; the new last direction is quadratic with the knots of arc().
Patch revolve(const Patch& patch, const Point& point, const Point& axis, double angle);
/// Bilinearly blended Coons surface of four boundary curves in the order west, east, south, north, or the trilinear
/// Coons volume of six boundary surfaces (then front, back). West and east run along ξ² (and ξ³), south and north along
/// ξ¹ (and ξ³), front and back along ξ¹ and ξ². The boundary is exact. Throws Error if curves or surfaces do not meet
/// within 1e-9 of the size, or meet with different weights.
Patch coons(const std::vector<Patch>& boundary);

} // namespace signorini::nurbs
