#pragma once
// Solids cut open by a plane.

#include "view/solid.hpp"

namespace signorini::view {

/// What lies on the side that the normal points to is taken away.
struct CutPlane {
  Vec<3> point, normal; ///< of any length but zero
};

/// What is left of a surface; values and normals at the cut are interpolated. Distances below `tolerance` count as
/// none.
Surface cut(const Surface& surface, const CutPlane& plane, double tolerance);

/// What is left of a line.
std::vector<SurfaceLine> cut(const SurfaceLine& line, const CutPlane& plane, double tolerance);

/// Where a surface meets the plane, piece by piece, with the surface's normals.
std::vector<SurfaceLine> traces(const Surface& surface, const CutPlane& plane, double tolerance);

/// Where a surface turns away from an eye that looks along −z, piece by piece.
std::vector<SurfaceLine> outline(const Surface& surface);

/// What is left of a solid, with the cut face: coloured by the values inside, with its elements' borders and its rim.
/// Needs the insides of all elements that the plane crosses.
Solid cut(const Solid& solid, const CutPlane& plane);

} // namespace signorini::view
