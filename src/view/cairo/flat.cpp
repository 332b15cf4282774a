// Entry of the module: writes figures by Cairo as PNG, SVG and PDF.
#include "base/error.hpp"
#include "view/cairo/parts.hpp"
#include "view/figure.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <pango/pango.h>

#include <algorithm>
#include <memory>

namespace signorini::view {
namespace {

constexpr double points_per_pixel = 0.45; // of a PDF: 1600 pixels are 10 inches
constexpr int image_scale = 2;            // of images in SVG and PDF, which may be printed or enlarged

struct Destroy {
  void operator()(cairo_t* paper) const { cairo_destroy(paper); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, Destroy>;
using Paper = std::unique_ptr<cairo_t, Destroy>;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

Surface make_surface(const std::array<int, 2>& size, Format format, bool transparent, std::string& bytes) {
  const double width = size[0], height = size[1];
  if (format == Format::pdf) {
    Surface made(
        cairo_pdf_surface_create_for_stream(append, &bytes, points_per_pixel * width, points_per_pixel * height));
    // A fixed time stamp: equal figures give equal bytes.
    cairo_pdf_surface_set_metadata(made.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
    return made;
  }
  if (format == Format::svg) {
    Surface made(cairo_svg_surface_create_for_stream(append, &bytes, width, height));
    cairo_svg_surface_set_document_unit(made.get(), CAIRO_SVG_UNIT_PX);
    return made;
  }
  return Surface(cairo_image_surface_create(transparent ? CAIRO_FORMAT_ARGB32 : CAIRO_FORMAT_RGB24, size[0], size[1]));
}

void set_color(cairo_t* paper, const Rgb& color, double opacity = 1) {
  cairo_set_source_rgba(paper, color[0] / 255.0, color[1] / 255.0, color[2] / 255.0, opacity);
}

/// Draws marks on paper of this height; y points downwards in Cairo.
struct Pen {
  cairo_t* paper;
  double height;

  void path(const std::vector<Vec2>& line) const {
    cairo_new_path(paper);
    for (const Vec2& p : line) cairo_line_to(paper, p[0], height - p[1]);
  }

  void operator()(const Stroke& stroke) const {
    path(stroke.points);
    set_color(paper, stroke.color);
    cairo_set_line_width(paper, stroke.width);
    cairo_set_dash(paper, stroke.dash.data(), static_cast<int>(stroke.dash.size()), 0);
    cairo_stroke(paper);
  }

  void operator()(const Fill& fill) const {
    path(fill.outline);
    cairo_close_path(paper);
    set_color(paper, fill.color, fill.opacity);
    cairo_fill(paper);
  }

  void operator()(const Text&) const {}
};

bool has_image(const Plate& plate) {
  return !plate.reliefs.empty();
}

void draw_image(cairo_t* paper, Pixels pixels, int scale) {
  const Surface image(cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(pixels.argb.data()),
                                                          CAIRO_FORMAT_ARGB32, pixels.size[0], pixels.size[1],
                                                          4 * pixels.size[0]));
  cairo_save(paper);
  cairo_scale(paper, 1.0 / scale, 1.0 / scale);
  cairo_set_source_surface(paper, image.get(), 0, 0);
  cairo_paint(paper);
  cairo_restore(paper);
  cairo_surface_finish(image.get()); // file writers take a copy
}

/// White or transparent background. Vector formats cannot clear existing content.
void clear(cairo_t* paper, bool transparent) {
  cairo_set_operator(paper, transparent ? CAIRO_OPERATOR_CLEAR : CAIRO_OPERATOR_OVER);
  set_color(paper, white);
  cairo_paint(paper);
  cairo_set_operator(paper, CAIRO_OPERATOR_OVER);
}

/// Renders the plate in its own pixels.
void draw_plate(cairo_t* paper, const Plate& plate, Format format, bool transparent, const ImageMaker& image) {
  const int height = plate.drawing.size[1];
  if (has_image(plate)) {
    const int scale = format == Format::png ? 1 : image_scale;
    draw_image(paper, image(plate, scale, transparent), scale);
  }
  cairo_set_line_join(paper, CAIRO_LINE_JOIN_ROUND);
  for (const Mark& mark : plate.drawing.marks) std::visit(Pen{paper, static_cast<double>(height)}, mark);
  for (const Mark& mark : plate.drawing.marks)
    if (const Text* text = std::get_if<Text>(&mark)) draw_text(paper, *text, height);
}

std::string bytes(const Figure& figure, Format format, bool transparent, const ImageMaker& image) {
  std::string bytes;
  const Surface surface = make_surface(figure.size, format, transparent, bytes);
  const Paper paper(cairo_create(surface.get()));
  if (format == Format::pdf) cairo_scale(paper.get(), points_per_pixel, points_per_pixel);
  if (!transparent) clear(paper.get(), false);
  for (std::size_t i = 0; i < figure.plates.size(); ++i) {
    const auto& [at, plate] = figure.plates[i];
    const auto [width, height] = plate.drawing.size;
    cairo_save(paper.get());
    cairo_translate(paper.get(), at[0], figure.size[1] - at[1] - height);
    cairo_rectangle(paper.get(), 0, 0, width, height);
    cairo_clip(paper.get());
    if (i > 0) clear(paper.get(), transparent && format == Format::png); // clear the plates beneath
    draw_plate(paper.get(), plate, format, transparent, image);
    cairo_restore(paper.get());
  }
  const auto check = [&] {
    const cairo_status_t status =
        cairo_status(paper.get()) ? cairo_status(paper.get()) : cairo_surface_status(surface.get());
    require(status == CAIRO_STATUS_SUCCESS, "view.flat.failed",
            {{"width", figure.size[0]}, {"height", figure.size[1]}, {"reason", cairo_status_to_string(status)}});
  };
  check();
  if (format == Format::png)
    bytes = png_of(surface.get(), std::any_of(figure.plates.begin(), figure.plates.end(),
                                              [](const PlacedPlate& placed) { return has_image(placed.plate); }));
  cairo_surface_finish(surface.get());
  check();
  return format == Format::svg ? searchable(bytes, figure) : bytes;
}

std::string describe() {
  return std::string("Cairo ") + cairo_version_string() + ", Pango " + pango_version_string();
}

} // namespace
} // namespace signorini::view

extern "C" const signorini::view::FlatRenderer signorini_flat = {signorini::view::width_of, signorini::view::bytes,
                                                                 signorini::view::describe, &signorini::warning_sink};
