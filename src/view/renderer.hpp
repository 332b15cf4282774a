#pragma once
// Rendering without a display. VTK and OpenGL live in a module of their own (src/view/vtk) that is loaded by the first
// picture: they take longer to load than a short script takes to run.

#include "view/frame.hpp"
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

struct PlacedRaster {
  std::array<int, 2> at; ///< its bottom left corner in the picture, pixels
  Raster raster;
};

/// Parts of a picture; later ones cover earlier ones.
struct Image {
  std::array<int, 2> size; ///< pixels
  std::vector<PlacedRaster> parts;
  bool transparent; ///< no ground behind them; else white
};

/// The module's table of functions, found under the name `signorini_renderer`.
struct Renderer {
  std::string (*png)(const Image& image); ///< the bytes of a PNG file
  std::string (*description)();
};

/// A drawing and what lies beneath its marks.
struct Plate {
  Drawing drawing;
  std::vector<Field> fields = {};
  Relief relief = {};
  std::vector<Frame> frames = {}; ///< where states stand on it
};

struct PlacedPlate {
  std::array<int, 2> at; ///< its bottom left corner on the whole, pixels
  Plate plate;
};

/// The bytes of a PNG file: plates laid over a whole of this size, on white ground or on none. Throws Error when no
/// off-screen context can be made.
std::string png(const std::array<int, 2>& size, std::vector<PlacedPlate> plates, bool transparent = false);

/// Of one plate.
std::string png(Plate plate, bool transparent = false);

/// What renders, for --doctor: "VTK 9.1.0, llvmpipe …, OpenGL 4.5 …".
std::string renderer_description();

} // namespace signorini::view
