#pragma once
// Lines of text, set by Pango in the first fonts that have their characters.

#include "view/drawing.hpp"

#include <cairo.h>

namespace signorini::view {

/// Width in pixels; proportional to the size.
double width_of(const std::string& utf8, double size);

/// Draws a text on paper of this height, y upwards. Characters that no font has become boxes, with a warning.
void draw_text(cairo_t* paper, const Text& text, double height);

} // namespace signorini::view
