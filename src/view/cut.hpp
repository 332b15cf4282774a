#pragma once
// Bodies and obstacles cut open by a plane.

#include "view/panel.hpp"

namespace signorini::view {

/// What is left of a surface; values and normals at the cut are interpolated. Distances below `tolerance` count as
/// none.
Surface cut(const Surface& surface, const CutPlane& plane, double tolerance);

/// What is left of lines.
std::vector<SurfaceLine> cut(const std::vector<SurfaceLine>& lines, const CutPlane& plane, double tolerance);

/// What is left of an obstacle, with a rim where it is cut.
RigidSurface cut(const RigidSurface& rigid, const CutPlane& plane, double tolerance);

/// Where a function with these values at a surface's points changes its sign, with the surface's normals.
std::vector<SurfaceLine> zeros(const Surface& surface, const VectorX& values);

/// Where a surface meets the plane.
std::vector<SurfaceLine> traces(const Surface& surface, const CutPlane& plane, double tolerance);

/// The mirror x, y or z = 0 (axis 0, 1, 2) where points lie on both of its sides, as a cut that takes the lesser side
/// away, with a warning: there a body and its image would lie on each other. Nothing where they lie on one side.
std::optional<CutPlane> crossed_mirror(const Points& points, int axis);

/// What is left of a body; of a solid with the cut face: colored by the values inside, with its elements' borders and
/// its rim. Needs the insides of all elements that the plane crosses.
Body cut(const Body& body, const CutPlane& plane);

} // namespace signorini::view
