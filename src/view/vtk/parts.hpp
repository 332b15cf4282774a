#pragma once
// Interface between the parts of the module with VTK.

#include "view/figure.hpp"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace signorini::view {

/// Pixels of the render window in each direction: a multiple of all supersampling factors.
inline constexpr int tile_size = 768;

/// The render window of the program, which needs no display: the only place that depends on how VTK renders
/// off-screen. Throws Error when no off-screen context can be created.
vtkRenderWindow& offscreen_window();

/// Adds a relief beneath z = 0 and a light.
void add_relief(vtkRenderer& renderer, const Relief& relief);

} // namespace signorini::view
