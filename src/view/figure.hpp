#pragma once
// Figures, their bytes as PNG, SVG or PDF, and the modules that draw them.

#include "base/warning.hpp"
#include "os/file_kind.hpp"
#include "view/frame.hpp"
#include "view/relief.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace signorini::view {

/// A drawing and the relief beneath its marks.
struct Plate {
  Drawing drawing;
  std::vector<Relief> reliefs = {};
  std::vector<Frame> frames = {}; ///< the frames of its states
};

struct PlacedPlate {
  std::array<int, 2> at; ///< bottom left corner in the figure, pixels
  Plate plate;
};

/// A figure of this size, made of plates; later ones cover earlier ones.
struct Figure {
  std::array<int, 2> size; ///< pixels
  std::vector<PlacedPlate> plates;
};

/// A figure with one plate.
Figure figure_of(Plate plate);

enum class Format { png, svg, pdf };

/// The extension of a file name in lower case, with its dot.
std::string file_ending(const std::string& file);

/// By the extension of a file name. Throws Error unless it is .png, .svg or .pdf.
Format format_of(const std::string& file);

/// The kind of a file of a format.
FileKind kind_of(Format format);

/// The bytes of a file, on white or transparent background. Lines and texts are vectors in SVG and PDF, with embedded
/// fonts; fields and surfaces in space are images. Equal figures give equal bytes. Throws Error when images need an
/// off-screen OpenGL context and none can be created.
std::string bytes_of(const Figure& figure, Format format, bool transparent = false);

/// Rows from the top; each pixel is 0xAARRGGBB with colors premultiplied by alpha.
struct Pixels {
  std::array<int, 2> size;
  std::vector<std::uint32_t> argb;
};

/// Returns the bytes of picture i (from 0) of a series.
using PictureMaker = std::function<std::string(int index)>;
/// Returns the image beneath a plate's marks, as image_of().
using ImageMaker = std::function<Pixels(const Plate& plate, int scale, bool transparent)>;

/// The functions of the module with VTK.
struct Renderer {
  Pixels (*image)(const Plate& plate, int scale, bool transparent);
  std::string (*description)(); ///< "VTK 9.1.0, llvmpipe …, OpenGL 4.5 …"
};

/// The functions of the module with Cairo.
struct FlatRenderer {
  double (*text_width)(const std::string& utf8, double size);
  std::string (*bytes)(const Figure& figure, Format format, bool transparent, const ImageMaker& image);
  std::string (*description)(); ///< "Cairo 1.16.0, Pango 1.50.12"
  WarningSink* warning_sink;    ///< that of the module
};

/// Throw Error when the module is missing.
const Renderer& renderer();
const FlatRenderer& flat_renderer();

/// The image beneath the marks of a plate, with scale × scale pixels per pixel of the drawing, on white or transparent
/// background. Throws Error when no off-screen context can be created.
Pixels image_of(const Plate& plate, int scale, bool transparent);

} // namespace signorini::view
