#pragma once
// The parts of the module with Cairo and Pango.

#include "view/figure.hpp"

#include <cairo.h>

namespace signorini::view {

/// The width of a line of text in pixels; proportional to the size.
double width_of(const std::string& utf8, double size);

/// Draws a line of text on paper of this height, y upwards, in the first fonts that have its characters. Those that no
/// font has become boxes, with a warning.
void draw_text(cairo_t* paper, const Text& text, double height);

/// The bytes of a PNG file of an image surface, with opacity where its format has it. `shaded`: colors run into each
/// other, so that the filters of rows pay; for charts, which Cairo's own writer would filter too, that takes three
/// times as long as drawing them.
std::string png_of(cairo_surface_t* image, bool shaded);

/// Cairo draws texts of an SVG as outlines, which look the same everywhere. This adds the texts themselves, unseen, in
/// their places, so that they can be found and selected, and numbers the parts within the file: Cairo counts them
/// through the whole process.
std::string searchable(const std::string& svg, const Figure& figure);

} // namespace signorini::view
