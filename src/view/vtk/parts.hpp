#pragma once
// Interface between the parts of the module with VTK.

#include "view/figure.hpp"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace signorini::view {

/// The render window of the program, which needs no display, set to a size in pixels: the only place that depends on
/// how VTK renders off-screen. Throws Error when no off-screen context can be created.
vtkRenderWindow& offscreen_window(std::array<int, 2> size);

/// Adds a relief beneath z = 0 and a light.
void add_relief(vtkRenderer& renderer, const Relief& relief);

} // namespace signorini::view
