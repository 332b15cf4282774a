#pragma once
// The bytes of a PNG file.

#include <cairo.h>
#include <string>

namespace signorini::view {

/// Of an image surface, with opacity where its format has it. Cairo's own writer tries all filters on each row, which
/// takes three times as long as to draw a chart.
std::string png_of(cairo_surface_t* image);

} // namespace signorini::view
