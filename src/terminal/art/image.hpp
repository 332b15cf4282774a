#pragma once
// Pixels of a PNG file.

#include <cstdint>
#include <string>
#include <vector>

namespace signorini::terminal {

struct Image {
  int width = 0, height = 0;
  int stride = 0;                   ///< bytes of a row
  std::vector<std::uint8_t> pixels; ///< red, green, blue; white where the file is transparent
};

/// `alignment`: rows begin at multiples of so many bytes.
Image decoded(const std::string& png, int alignment);

} // namespace signorini::terminal
