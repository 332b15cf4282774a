#pragma once
// Figures on paper, their bytes as PNG, SVG or PDF, and the modules that draw them.

#include "base/warning.hpp"
#include "view/frame.hpp"
#include "view/relief.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace signorini::view {

/// A drawing and what lies beneath its marks.
struct Plate {
  Drawing drawing;
  std::vector<Relief> reliefs = {};
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

enum class Format { png, svg, pdf };

/// The ending of a file's name in lower case, with its dot.
std::string file_ending(const std::string& file);

/// By the ending of a file's name. Throws Error unless it is .png, .svg or .pdf.
Format format_of(const std::string& file);

/// The bytes of a file, on white ground or on none. Lines and texts are vectors in SVG and PDF, with fonts embedded;
/// fields and surfaces in space are images. The same figure gives the same bytes. Throws Error where the images need an
/// off-screen OpenGL context and none can be made.
std::string bytes_of(const Figure& figure, Format format, bool transparent = false);

/// Rows from the top; each pixel is 0xAARRGGBB with its colors multiplied by its opacity.
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
  /// Writes a film of `rate` pictures per second, Theora in Ogg; null where VTK has been built without it. Throws Error
  /// on pictures of several sizes.
  void (*ogv)(const std::string& file, int count, int rate, const PictureMaker& png);
  std::string (*description)(); ///< "VTK 9.1.0, llvmpipe …, OpenGL 4.5 …"
};

/// The functions of the module with Cairo.
struct FlatRenderer {
  double (*text_width)(const std::string& utf8, double size);
  std::string (*bytes)(const Figure& figure, Format format, bool transparent, const ImageMaker& image);
  std::string (*description)(); ///< "Cairo 1.16.0, Pango 1.50.12"
  WarningSink* warning_sink;    ///< the module's own
};

/// Throw Error where the module is missing.
const Renderer& renderer();
const FlatRenderer& flat_renderer();

/// What lies beneath the marks of a plate, in `scale` pixels for one of the drawing each way; on white or on no ground.
/// Throws Error when no off-screen context can be made.
Pixels image_of(const Plate& plate, int scale, bool transparent);

} // namespace signorini::view
