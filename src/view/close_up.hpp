#pragma once
// A picture with a part of it magnified in a box.

#include "view/picture.hpp"

#include <functional>

namespace signorini::view {

/// Makes the picture of a state; where an extent is given, so large at least.
using WholeMaker = std::function<Plate(const std::optional<Box>& extent)>;
/// Makes the magnified part, no larger than a size in pixels.
using DetailMaker = std::function<Plate(const std::array<int, 2>& most)>;

/// The bytes of a PNG file: the picture of one state, and in a corner of its frame that hides no body the magnified
/// part, joined by lines to where it belongs. The frame gets higher where no corner is free.
std::string with_close_up(const WholeMaker& whole, const DetailMaker& detail, bool transparent);

} // namespace signorini::view
