#pragma once
// The parts of the module with VTK.

#include "view/figure.hpp"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace signorini::view {

/// The program's render window, which needs no display, set to a size in pixels: the one place that knows how VTK
/// renders without one. Throws Error when no off-screen context can be made.
vtkRenderWindow& offscreen_window(std::array<int, 2> size);

/// Adds a relief beneath z = 0 and a light for what is lit.
void add_relief(vtkRenderer& renderer, const Relief& relief);

/// Writes pictures to a film of `rate` per second, Theora in Ogg. Throws Error on pictures of several sizes.
void draw_ogv(const std::string& file, int count, int rate, const PictureMaker& png);

} // namespace signorini::view
