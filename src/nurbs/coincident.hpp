#pragma once
// Control points that are one point of the body by the way its patch is folded: collapsed edges and closed seams.

#include "nurbs/discretization.hpp"

#include <vector>

namespace signorini::nurbs {

/// Groups of functions (two or more each, both lists rising) whose control points are one point of the body, so that
/// they must move as one, or the body tears there:
///   - an edge of the patch that is one point, such as a sphere's pole on one radius, and every line of control points
///     of a face that collapses to a line or to a point;
///   - two opposite faces that are the same everywhere, point by point with equal weights, such as the seam of a full
///     turn.
/// Points that are the same by accident (two edges that touch, a slit that does not reach from face to face) are left
/// alone. Points count as the same to 1e-10 of the body's size. Throws Error when a side of a solid collapses across a
/// layer, for rows of different spaces meet there in one curve and have no points to pair, and when a contact face is a
/// closed seam.
std::vector<std::vector<int>> coincident_functions(const Discretization& space);

/// The directions (counted from 0) whose two faces are one seam, where coincident_functions() joins them.
std::vector<int> closed_directions(const Discretization& space);

} // namespace signorini::nurbs
