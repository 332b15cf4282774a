#pragma once
// Figures on paper, and their bytes as PNG, SVG or PDF.

#include "view/frame.hpp"
#include "view/relief.hpp"

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

} // namespace signorini::view
