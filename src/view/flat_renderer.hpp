#pragma once
// The module that draws on paper with Cairo and sets texts with Pango (src/view/cairo).

#include "view/renderer.hpp"

namespace signorini::view {

/// Makes the image beneath a plate's marks, as image_of().
using ImageMaker = std::function<Pixels(const Plate& plate, int scale, bool transparent)>;

/// The functions of the module.
struct FlatRenderer {
  double (*text_width)(const std::string& utf8, double size);
  std::string (*bytes)(const Figure& figure, Format format, bool transparent, const ImageMaker& image);
  std::string (*description)(); ///< "Cairo 1.16.0, Pango 1.50.12"
};

const FlatRenderer& flat_renderer();

} // namespace signorini::view
