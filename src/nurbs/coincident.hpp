#pragma once
// Control points that coincide by the patch's topology: collapsed edges (poles) and closed seams [theory 4.6].

#include "nurbs/discretization.hpp"

#include <vector>

namespace signorini::nurbs {

/// Groups of functions (two or more each, both lists increasing) whose control points are the same point of the body
/// and must share displacements, since otherwise the body would tear there:
///   - an edge of the patch that is one point, such as the pole of a sphere at one radius, and every line of control
///     points of a face that collapses to a line or a point;
///   - two opposite faces that coincide point by point with equal weights, such as the seam of a full revolution.
/// Points that coincide otherwise (two edges that touch, a slit that does not extend from face to face) stay
/// independent. Points coincide within 1e-10 of the body's size. Throws Error if a side of a solid collapses across a
/// layer, where the rows' different functions meet in one curve and their points do not correspond, and if a contact
/// face is a closed seam.
std::vector<std::vector<int>> coincident_functions(const Discretization& space);

/// Directions (from 0) whose two faces form a seam that coincident_functions() joins.
std::vector<int> closed_directions(const Discretization& space);

} // namespace signorini::nurbs
