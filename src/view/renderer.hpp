#pragma once
// Rendering without a display. VTK and OpenGL live in a module of their own (src/view/vtk) that is loaded by the first
// picture: they take longer to load than a short script takes to run.

#include "view/relief.hpp"

#include <array>
#include <string>
#include <vector>

namespace signorini::view {

/// What the module draws: surfaces in space, coloured areas, then plain triangles in their order, then texts.
struct Raster {
  std::array<int, 2> size; ///< pixels
  Relief relief;
  std::vector<Field> fields;
  std::vector<Vec2> corners; ///< three per triangle
  std::vector<Rgb> colours;  ///< one per triangle
  std::vector<Text> texts;
};

/// The module's table of functions, found under the name `signorini_renderer`.
struct Renderer {
  std::string (*png)(const Raster& raster); ///< the bytes of a PNG file
  std::string (*description)();
};

/// The bytes of a PNG file on white ground. Throws Error when no off-screen context can be made.
std::string png(const Drawing& drawing, std::vector<Field> fields = {}, Relief relief = {});

/// What renders, for --doctor: "VTK 9.1.0, llvmpipe …, OpenGL 4.5 …".
std::string renderer_description();

} // namespace signorini::view
