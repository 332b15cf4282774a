#pragma once
// The one place that knows how VTK renders without a display.

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>

namespace signorini::view {

/// A render window of the given size in pixels that needs no display; contexts are reused between calls of equal size.
/// Throws Error when no off-screen context can be made.
vtkSmartPointer<vtkRenderWindow> offscreen_window(std::array<int, 2> size);

/// Writes what the window shows as PNG, whole or not at all.
void write_png(vtkRenderWindow& window, const std::string& file);

/// What renders, for --doctor: "OSMesa 8.0, llvmpipe …, OpenGL 4.5".
std::string renderer_description();

} // namespace signorini::view
