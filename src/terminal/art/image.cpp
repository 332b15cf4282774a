#include "terminal/art/image.hpp"

#include "base/error.hpp"

#include <png.h>

namespace signorini::terminal {

Image decoded(const std::string& png, int alignment) {
  png_image file = {};
  file.version = PNG_IMAGE_VERSION;
  bool ok = png_image_begin_read_from_memory(&file, png.data(), png.size()) != 0;
  file.format = PNG_FORMAT_RGB;
  Image image{static_cast<int>(file.width), static_cast<int>(file.height), 0, {}};
  image.stride = (3 * image.width + alignment - 1) / alignment * alignment;
  image.pixels.resize(static_cast<std::size_t>(image.stride) * file.height);
  const png_color white = {255, 255, 255};
  ok = ok && png_image_finish_read(&file, &white, image.pixels.data(), image.stride, nullptr) != 0;
  png_image_free(&file);
  require(ok, "terminal.png.read", {{"reason", file.message}});
  return image;
}

} // namespace signorini::terminal
