#pragma once
// Curves and surfaces as points, triangles and lines over their true geometry.

#include "base/window.hpp"
#include "nurbs/patch.hpp"
#include "view/solid.hpp"

namespace signorini::bind {

/// A curve has points without triangles; the normals of curves and of plane surfaces are zero.
struct SampledPatch {
  view::Surface surface;
  std::vector<view::SurfaceLine> mesh_lines; ///< along the knots within
  std::vector<view::SurfaceLine> rim;        ///< a curve itself, the four sides of a surface
};

/// Of a curve or a surface in 2D or 3D, finer where windows need it. `sign`: of the normals ∂x/∂ξ¹ × ∂x/∂ξ².
SampledPatch sampled(const nurbs::Patch& patch, double sign = 1, const std::vector<Window>& windows = {});

/// The point in space, z = 0 for those of the plane.
Vec<3> place(const nurbs::Patch& patch, const VectorX& xi);

/// As many points as it takes along a direction, the other parameters of `xi` fixed, from the first knot over a
/// fraction of the direction's length.
view::Points line_along(const nurbs::Patch& patch, VectorX xi, int direction, double fraction);

} // namespace signorini::bind
