#pragma once
// Several pictures in one, each with a colour bar of its own.

#include "view/picture.hpp"

#include <functional>

namespace signorini::view {

/// Makes the picture of a number (from 0), no larger than a size in pixels.
using PlateMaker = std::function<Plate(int index, const std::array<int, 2>& most)>;

/// The bytes of a PNG file: `count` pictures in rows from left to right, with the options' title, size and ground, in
/// so many columns as the options say or as show the first picture largest. Throws Error when they find no room.
std::string side_by_side(int count, const PictureOptions& options, const PlateMaker& make);

} // namespace signorini::view
