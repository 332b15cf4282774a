#pragma once
// Cuts bodies and obstacles by a plane.

#include "view/panel.hpp"

namespace signorini::view {

/// Distances from a cut, relative to the size of all, that count as zero: a hundredth of a pixel. Element borders that
/// lie in the cut but for the error of a solution would otherwise cross it in jagged lines.
inline constexpr double cut_tolerance = 1e-5;

/// The remaining part of a surface; values and normals at the cut are interpolated. Distances below `tolerance` count
/// as zero.
Surface cut(const Surface& surface, const CutPlane& plane, double tolerance);

/// The remaining parts of lines.
std::vector<SurfaceLine> cut(const std::vector<SurfaceLine>& lines, const CutPlane& plane, double tolerance);

/// The remaining part of an obstacle, with a rim along the cut.
RigidSurface cut(const RigidSurface& rigid, const CutPlane& plane, double tolerance);

/// The zero level line of a function given by its values at the points of a surface, with the surface's normals.
std::vector<SurfaceLine> zeros(const Surface& surface, const VectorX& values);

/// The intersection of a surface and the plane.
std::vector<SurfaceLine> traces(const Surface& surface, const CutPlane& plane, double tolerance);

/// The mirror x, y or z = 0 (axis 0, 1, 2) as a cut, if points lie on both of its sides: removes the smaller side, with
/// a warning, because body and image would overlap there. Empty if all points lie on one side.
std::optional<CutPlane> crossed_mirror(const Points& points, int axis);

/// The remaining part of a body; of a solid with the cut face, colored by the values inside, with element borders and
/// rim. Requires the lattices of all elements that the plane intersects.
Body cut(const Body& body, const CutPlane& plane);

} // namespace signorini::view
