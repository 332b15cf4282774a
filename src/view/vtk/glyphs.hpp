#pragma once
// Text on a pixel image, drawn by FreeType.

#include "view/drawing.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace signorini::view {

/// Three bytes per pixel, rows from the bottom up.
struct Pixels {
  std::array<int, 2> size;
  std::vector<std::uint8_t> rgb;
};

/// Blends the text over the image; what lies outside is cut off.
void draw_text(Pixels& image, const Text& text);

} // namespace signorini::view
