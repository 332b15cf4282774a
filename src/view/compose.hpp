#pragma once
// Several pictures in one figure: side by side, or a magnified part in a box on the whole.

#include "view/picture.hpp"

#include <functional>

namespace signorini::view {

/// Makes the picture of a number (from 0), no larger than a size in pixels.
using FigureMaker = std::function<Figure(int index, const std::array<int, 2>& most)>;

/// `count` pictures in rows from left to right, with the options' title and size, in so many columns as the options say
/// or, where they say nothing, as show the first picture largest without the whole being a tower.
/// Throws Error when they find no room.
Figure side_by_side(int count, const PictureOptions& options, const FigureMaker& make);

/// The style of a picture of this size that is a part of a whole: its text is between that of a picture of its own and
/// the whole's.
Style part_style(const std::array<int, 2>& size, const Style& whole);

/// Makes a picture (from 0) of states; where an extent is given, each so large at least.
using WholeMaker = std::function<Plate(int picture, const std::optional<Box>& extent)>;
/// Makes the magnified part of a state (from 0) of a picture, no larger than a size in pixels.
using DetailMaker = std::function<Plate(int picture, int state, const std::array<int, 2>& most)>;

/// Where magnified parts go, in all states alike.
struct CloseUpPlan {
  double share = 0;               ///< of the frame's height
  int corner = 0;                 ///< of the frame
  long hidden = 0;                ///< points of bodies that the parts hide
  std::optional<Box> extent = {}; ///< of each state at least
};

/// The largest parts, and the corner in which they hide no body in any state of the pictures. The frames get higher
/// where no corner is free. Throws Error where a frame is too small.
CloseUpPlan plan_close_ups(int pictures, const WholeMaker& whole, const DetailMaker& detail);

/// A picture of states, and in each one's frame the magnified part, joined by lines to where it belongs.
Figure with_close_ups(int picture, const CloseUpPlan& plan, const WholeMaker& whole, const DetailMaker& detail);

/// The style of a magnified part in a picture of this style: numbers a little smaller, and less air.
Style close_up_style(Style whole);

} // namespace signorini::view
