#pragma once
// Links between borders of sheets of a surface.

#include <array>
#include <map>

namespace signorini::contact {

/// A border of an element: at the start (0) or end (1) of direction α.
using ElementBorder = std::array<int, 3>; ///< element, α, 0 or 1

struct SheetLink {
  ElementBorder to;
  bool reversed; ///< its other direction runs against that of the border from which the link leads
};
/// By border, in both directions.
using SheetLinks = std::map<ElementBorder, SheetLink>;

} // namespace signorini::contact
