#pragma once
// Several pictures in one, each with a colour bar of its own.

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

} // namespace signorini::view
