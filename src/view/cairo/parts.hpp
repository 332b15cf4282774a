#pragma once
// Interface between the parts of the module with Cairo and Pango.

#include "view/figure.hpp"

#include <cairo.h>

namespace signorini::view {

/// The width of a line of text in pixels; proportional to the size.
double width_of(const std::string& utf8, double size);

/// Draws a line of text on paper of this height, y upwards, in the first fonts that have its characters. Characters
/// without a font become boxes, with a warning.
void draw_text(cairo_t* paper, const Text& text, double height);

/// Encodes an image surface as PNG, with opacity if its format has it. `shaded`: smooth colors, for which row filters
/// are worthwhile; Cairo's own writer filters charts as well, which takes three times as long as drawing them.
std::string png_of(cairo_surface_t* image, bool shaded);

/// Cairo writes texts of an SVG as outlines, which look the same everywhere. This adds the texts as invisible elements
/// in their positions, so that they can be searched and selected, and renumbers ids within the file, because Cairo
/// counts them over the whole process.
std::string searchable(const std::string& svg, const Figure& figure);

} // namespace signorini::view
