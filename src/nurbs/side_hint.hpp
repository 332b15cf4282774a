#pragma once
// What somebody means who calls a side by another name than west, east, south, north, front and back.

#include <string>

namespace signorini::nurbs {

/// The name of the side of a patch of 2 or 3 parametric directions that is probably meant: "north" for "top" in the
/// plane, "back" in space (as on a block along the axes), the nearest for "nroth"; empty when none is near.
std::string meant_side(const std::string& name, int parametric_dimension);

} // namespace signorini::nurbs
