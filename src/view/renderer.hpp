#pragma once
// What takes long to load, or only some runs need, lives in modules of its own in lib/signorini, which the first
// picture loads: Cairo with Pango (src/view/cairo), OpenGL without a display with VTK (src/view/vtk).

#include "base/warning.hpp"
#include "view/figure.hpp"

#include <cstdint>
#include <functional>

namespace signorini::view {

/// Rows from the top; each pixel is 0xAARRGGBB with its colours multiplied by its opacity.
struct Pixels {
  std::array<int, 2> size;
  std::vector<std::uint32_t> argb;
};

/// Makes the bytes of a series' picture of a number (from 0).
using PictureMaker = std::function<std::string(int index)>;
/// Makes the image beneath a plate's marks, as image_of().
using ImageMaker = std::function<Pixels(const Plate& plate, int scale, bool transparent)>;

/// The functions of the module with VTK.
struct Renderer {
  Pixels (*image)(const Plate& plate, int scale, bool transparent);
  /// Writes a film, Theora in Ogg; null where VTK has been built without it.
  void (*ogv)(const std::string& file, int count, int rate, const PictureMaker& png);
  std::string (*description)();
};

/// The functions of the module with Cairo.
struct FlatRenderer {
  double (*text_width)(const std::string& utf8, double size);
  std::string (*bytes)(const Figure& figure, Format format, bool transparent, const ImageMaker& image);
  std::string (*description)(); ///< "Cairo 1.16.0, Pango 1.50.12"
  WarningSink* warning_sink;    ///< the module's own
};

/// Throws Error where the module is missing.
const FlatRenderer& flat_renderer();

/// What lies beneath the marks of a plate, in `scale` pixels for one of the drawing each way; on white or on no ground.
/// Throws Error when no off-screen context can be made.
Pixels image_of(const Plate& plate, int scale, bool transparent);

/// Writes a film of `rate` pictures per second, Theora in Ogg. Throws Error where VTK has been built without it, and on
/// pictures of several sizes.
void write_ogv(const std::string& file, int count, int rate, const PictureMaker& png);

/// Whether VTK has been built with Theora.
bool has_theora();

/// What renders, for --doctor: "VTK 9.1.0, llvmpipe …, OpenGL 4.5 …".
std::string renderer_description();

} // namespace signorini::view
