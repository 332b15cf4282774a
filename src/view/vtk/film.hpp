#pragma once
// Films by VTK itself.

#include "view/renderer.hpp"

namespace signorini::view {

/// Writes pictures to a film of `rate` per second, Theora in Ogg. Throws Error on pictures of several sizes.
void draw_ogv(const std::string& file, int count, int rate, const PictureMaker& png);

} // namespace signorini::view
