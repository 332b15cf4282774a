#include "base/error.hpp"
#include "terminal/art/image.hpp"
#include "terminal/art/parts.hpp"

#include <algorithm>
#include <memory>
#include <sixel.h>

namespace signorini::terminal {
namespace {

constexpr int colors = 256, depth = 3;

using Dither = std::unique_ptr<sixel_dither_t, decltype(&sixel_dither_unref)>;
using Output = std::unique_ptr<sixel_output_t, decltype(&sixel_output_unref)>;

void check(SIXELSTATUS status) {
  require(SIXEL_SUCCEEDED(status), "terminal.sixel.failed", {{"reason", sixel_helper_format_error(status)}});
}

int append(char* data, int size, void* to) {
  static_cast<std::string*>(to)->append(data, static_cast<std::size_t>(size));
  return size;
}

Image resized(const Image& image, int width, int height) {
  Image smaller{width, height, depth * width, {}};
  smaller.pixels.resize(static_cast<std::size_t>(smaller.stride) * static_cast<std::size_t>(height));
  check(sixel_helper_scale_image(smaller.pixels.data(), image.pixels.data(), image.width, image.height,
                                 SIXEL_PIXELFORMAT_RGB888, width, height, SIXEL_RES_LANCZOS3, nullptr));
  return smaller;
}

/// libsixel's palettes have five bits per color, the lower ones zero: white would be gray.
void brighten(sixel_dither_t* dither) {
  unsigned char* palette = sixel_dither_get_palette(dither);
  for (int i = 0; i < 3 * sixel_dither_get_num_of_palette_colors(dither); ++i)
    palette[i] = static_cast<unsigned char>(std::min(255, palette[i] * 255 / 248));
}

} // namespace

std::string sixels(const std::string& png, int width, int height) {
  Image image = decoded(png, 1);
  if (image.width != width || image.height != height) image = resized(image, width, height);
  sixel_dither_t* made = nullptr;
  check(sixel_dither_new(&made, colors, nullptr));
  const Dither dither(made, sixel_dither_unref);
  // All pixels count, so that thin lines keep their colors.
  check(sixel_dither_initialize(dither.get(), image.pixels.data(), width, height, SIXEL_PIXELFORMAT_RGB888,
                                SIXEL_LARGE_NORM, SIXEL_REP_AVERAGE_PIXELS, SIXEL_QUALITY_FULL));
  brighten(dither.get());
  // Steps between colors would look like contours.
  sixel_dither_set_diffusion_type(dither.get(), SIXEL_DIFFUSE_FS);
  std::string bytes;
  sixel_output_t* opened = nullptr;
  check(sixel_output_new(&opened, append, &bytes, nullptr));
  const Output output(opened, sixel_output_unref);
  check(sixel_encode(image.pixels.data(), width, height, depth, dither.get(), output.get()));
  return bytes;
}

} // namespace signorini::terminal
