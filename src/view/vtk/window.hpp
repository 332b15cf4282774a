#pragma once
// The one place that knows how VTK renders without a display.

#include <vtkRenderWindow.h>

#include <array>

namespace signorini::view {

/// The program's render window, which needs no display, set to a size in pixels. Throws Error when no off-screen
/// context can be made.
vtkRenderWindow& offscreen_window(std::array<int, 2> size);

} // namespace signorini::view
