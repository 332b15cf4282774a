#include "view/cairo/parts.hpp"

#include "base/error.hpp"

#include <cstdint>
#include <png.h>
#include <vector>

namespace signorini::view {
namespace {

// Compression level of zlib. Sufficient for lines and texts on white: files a quarter larger than at level 6, in half
// the time.
constexpr int of_charts = 3, of_images = 6;

void append(png_structp png, png_bytep data, png_size_t length) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), length);
}

[[noreturn]] void refuse(png_structp, png_const_charp message) {
  fail("view.png.failed", {{"reason", message}});
}

/// 0xAARRGGBB with premultiplied alpha → red, green, blue and, if requested, alpha.
void unpack(const std::uint32_t* pixels, int width, bool opacity, png_byte* row) {
  for (int x = 0; x < width; ++x, row += opacity ? 4 : 3) {
    const std::uint32_t pixel = pixels[x], a = opacity ? pixel >> 24 : 255;
    const auto part = [&](int shift) {
      const std::uint32_t color = pixel >> shift & 255;
      return static_cast<png_byte>(a == 255 ? color : a == 0 ? 0 : (255 * color + a / 2) / a);
    };
    row[0] = part(16), row[1] = part(8), row[2] = part(0);
    if (opacity) row[3] = static_cast<png_byte>(a);
  }
}

} // namespace

std::string png_of(cairo_surface_t* image, bool shaded) {
  cairo_surface_flush(image);
  const int width = cairo_image_surface_get_width(image), height = cairo_image_surface_get_height(image);
  const bool opacity = cairo_image_surface_get_format(image) == CAIRO_FORMAT_ARGB32;
  std::string bytes;
  struct Writer {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, refuse, nullptr);
    png_infop info = png_create_info_struct(png);
    ~Writer() { png_destroy_write_struct(&png, &info); }
  } writer;
  png_structp png = writer.png;
  png_set_write_fn(png, &bytes, append, nullptr);
  png_set_IHDR(png, writer.info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
               opacity ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_compression_level(png, shaded ? of_images : of_charts);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, shaded ? PNG_ALL_FILTERS : PNG_FILTER_NONE);
  png_write_info(png, writer.info);
  std::vector<png_byte> row(static_cast<std::size_t>(opacity ? 4 : 3) * static_cast<std::size_t>(width));
  const unsigned char* data = cairo_image_surface_get_data(image);
  for (int y = 0; y < height; ++y) {
    const unsigned char* from = data + static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(image);
    unpack(reinterpret_cast<const std::uint32_t*>(from), width, opacity, row.data());
    png_write_row(png, row.data());
  }
  png_write_end(png, writer.info);
  return bytes;
}

} // namespace signorini::view
