#pragma once
// Round shapes of several patches without singular points. Neighboring faces have the same knots, control points and
// weights within rounding error.

#include "nurbs/transform.hpp"

#include <string>
#include <vector>

namespace signorini::nurbs {

/// A face of one of several patches.
struct PatchFace {
  int patch; ///< from 0
  Side side;
  bool operator==(const PatchFace&) const = default;
};

/// Faces that make up a named part of the surface.
struct Boundary {
  std::string name;
  std::vector<PatchFace> faces;
};

struct SeveralPatches {
  std::vector<Patch> patches;
  std::vector<Boundary> boundaries;
};

/// Disc of five patches of degree 2: 0 to 3 lie below, right, above and left, each with a quarter of the circle, ξ¹
/// counter-clockwise along it, ξ² from it (south, boundary "outer") to the core; 4 is the core, a square with its
/// corners at half the radius, ξ¹ and ξ² along x and y.
SeveralPatches disc(double radius, const Point& center);
/// Cylinder along y from `center` to `center` + (0, width, 0): the disc in the x-z plane, extruded. Outer patches: ξ¹
/// along the arc, ξ² along y, ξ³ from the circle (front, "outer") to the core; core: ξ¹, ξ², ξ³ along x, y, z. The
/// boundaries "south" and "north" are in y = center y and y = center y + width.
SeveralPatches cylinder(double radius, double width, const Point& center);
/// Torus about the z axis through `center`: the disc of radius `section` around the circle of radius `radius` in the
/// x-y plane. ξ² once around the axis from the x-z plane (south and north are the seam), otherwise as the cylinder's.
SeveralPatches torus(double radius, double section, const Point& center);
/// Ball of seven patches of degree 4: 0 to 5 lie at −z, x, y, −x, −y, z, ξ³ from the sphere (front, "outer") to the
/// core; 6 is the core, a cube along the axes with its corners at half the radius. Each patch has a sixth of the
/// sphere.
SeveralPatches ball(double radius, const Point& center);

} // namespace signorini::nurbs
