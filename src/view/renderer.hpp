#pragma once
// Rendering without a display. VTK and OpenGL live in a module of their own (src/view/vtk) that is loaded by the first
// picture: they take longer to load than a short script takes to run.

#include "view/frame.hpp"
#include "view/relief.hpp"

#include <array>
#include <functional>
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

/// Makes the bytes of a film's picture of a number (from 0).
using PngMaker = std::function<std::string(int index)>;

/// The module's table of functions, found under the name `signorini_renderer`.
struct Renderer {
  std::string (*png)(const Image& image); ///< the bytes of a PNG file
  /// Writes a film, Theora in Ogg; null where VTK has been built without it.
  void (*ogv)(const std::string& file, int count, int rate, const PngMaker& png);
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

/// Plates laid over a whole of this size; later ones cover earlier ones.
struct Figure {
  std::array<int, 2> size; ///< pixels
  std::vector<PlacedPlate> plates;
};

/// One plate alone.
Figure figure_of(Plate plate);

/// The bytes of a PNG file, on white ground or on none. Throws Error when no off-screen context can be made.
std::string png(Figure figure, bool transparent = false);

/// Of one plate.
std::string png(Plate plate, bool transparent = false);

/// Writes a film of `rate` pictures per second, Theora in Ogg. Throws Error where VTK has been built without it, and on
/// pictures of several sizes.
void write_ogv(const std::string& file, int count, int rate, const PngMaker& png);

/// Whether VTK has been built with Theora.
bool has_theora();

/// What renders, for --doctor: "VTK 9.1.0, llvmpipe …, OpenGL 4.5 …".
std::string renderer_description();

} // namespace signorini::view
