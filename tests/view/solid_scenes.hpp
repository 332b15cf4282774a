#pragma once
// Synthetic solids: smooth maps of the unit cube.

#include "view/picture.hpp"

#include <functional>

namespace signorini::view {

/// Maps the unit cube to space, right-handed.
using SolidMap = std::function<Vec<3>(const Vec<3>&)>;
/// The value at a point in space.
using SpaceField = std::function<double(const Vec<3>&)>;

/// The image of the unit cube with elements × elements × elements and pieces per element and direction, with samples of
/// all elements.
Body mapped_solid(const SolidMap& map, const std::array<int, 3>& elements, int divisions,
                  const SpaceField& field = nullptr);

SolidMap block_map(const Vec<3>& low, const Vec<3>& high);

/// A quarter of the upper half of a hollow sphere away from its pole, about the origin, x, y, z ≥ 0.
SolidMap shell_map(double inner, double outer);

double area(const Surface& surface);

} // namespace signorini::view
