#pragma once
// The bytes of a PNG file.

#include <cairo.h>
#include <string>

namespace signorini::view {

/// Of an image surface, with opacity where its format has it. `shaded`: colours run into each other, so that the
/// filters of rows pay; for charts, which Cairo's own writer would filter too, that takes three times as long as
/// drawing them.
std::string png_of(cairo_surface_t* image, bool shaded);

} // namespace signorini::view
