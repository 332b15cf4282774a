#pragma once
// A picture with a part of it magnified in a box.

#include "view/picture.hpp"

#include <functional>

namespace signorini::view {

/// Makes the picture of states; where an extent is given, each so large at least.
using WholeMaker = std::function<Plate(const std::optional<Box>& extent)>;
/// Makes the magnified part of a state (from 0), no larger than a size in pixels.
using DetailMaker = std::function<Plate(int state, const std::array<int, 2>& most)>;

/// The picture of states, and in a corner of each one's frame that hides no body the magnified part, joined by lines to
/// where it belongs. The frames get higher where no corner is free. Throws Error where a frame is too small.
Figure with_close_ups(const WholeMaker& whole, const DetailMaker& detail);

/// The style of a magnified part in a picture of this style: numbers a little smaller, and less air.
Style close_up_style(Style whole);

} // namespace signorini::view
