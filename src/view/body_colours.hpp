#pragma once
// The colours that bodies have in pictures of the plane and of space alike.
#include "view/colormap.hpp"

namespace signorini::view {

constexpr Rgb plain_colour = {203, 209, 214}; ///< a body without a field
constexpr Rgb mesh_colour = {45, 45, 45};     ///< borders of elements, rims
constexpr Rgb net_colour = {200, 60, 20};     ///< control points and the lines between them

} // namespace signorini::view
