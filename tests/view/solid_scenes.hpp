#pragma once
// Made-up solids: smooth maps of the unit cube.

#include "view/picture.hpp"

#include <functional>

namespace signorini::view {

/// Takes the unit cube to space, right-handed.
using SolidMap = std::function<Vec<3>(const Vec<3>&)>;
/// A value at a place in space.
using SpaceField = std::function<double(const Vec<3>&)>;

/// The image of the unit cube as elements × elements × elements with pieces per element and direction, all insides
/// sampled.
Body mapped_solid(const SolidMap& map, const std::array<int, 3>& elements, int divisions,
                  const SpaceField& field = nullptr);

SolidMap block_map(const Vec<3>& low, const Vec<3>& high);

/// A quarter of a hollow sphere's upper half away from its pole, about the origin, x, y, z ≥ 0.
SolidMap shell_map(double inner, double outer);

/// Area and enclosed volume (∫ x·n dA / 3) of a surface; the triangles turn as its normals say.
double area(const Surface& surface);
double volume(const Surface& surface);

} // namespace signorini::view
