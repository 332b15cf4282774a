#pragma once
// Several pictures in one figure: in rows, or a magnified part in a box on the picture.

#include "view/picture.hpp"

#include <functional>

namespace signorini::view {

/// Draws the picture of a number (from 0), at most of the given size in pixels.
using FigureMaker = std::function<Figure(int index, const std::array<int, 2>& most)>;

/// `count` pictures in rows from left to right, with the options' title and size, in the options' number of columns; by
/// default the one for which the first picture is largest and the figure not higher than wide. Throws Error when the
/// size is too small.
Figure side_by_side(int count, const PictureOptions& options, const FigureMaker& make);

/// The style of a picture of this size inside a larger figure: text sizes between those of a separate picture and those
/// of the figure.
Style part_style(const std::array<int, 2>& size, const Style& whole);

/// Draws picture i (from 0) of states; with an extent, each state shows at least that part.
using WholeMaker = std::function<Plate(int picture, const std::optional<Box>& extent)>;
/// Draws the magnified part of state i (from 0) of a picture, at most of the given size in pixels.
using DetailMaker = std::function<Plate(int picture, int state, const std::array<int, 2>& most)>;

/// Where magnified parts are drawn, the same in all states.
struct CloseUpPlan {
  double share = 0;               ///< of the height of the frame
  int corner = 0;                 ///< of the frame
  long hidden = 0;                ///< sample points of bodies that the magnified parts cover
  std::optional<Box> extent = {}; ///< minimum extent of each state
};

/// The largest magnified parts, in the corner where they cover no body in any state of the pictures. Frames are
/// enlarged upwards if no corner is free. Throws Error when a frame is too small.
CloseUpPlan plan_close_ups(int pictures, const WholeMaker& whole, const DetailMaker& detail);

/// A picture of states with the magnified part in the frame of each, joined by lines to the marked region.
Figure with_close_ups(int picture, const CloseUpPlan& plan, const WholeMaker& whole, const DetailMaker& detail);

/// The style of a magnified part in a picture of this style: smaller numbers and margins.
Style close_up_style(Style whole);

} // namespace signorini::view
