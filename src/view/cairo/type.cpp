#include "view/cairo/parts.hpp"

#include "base/error.hpp"
#include "base/warning.hpp"
#include "view/text.hpp"

#include <pango/pangocairo.h>

#include <memory>
#include <unordered_map>

namespace signorini::view {
namespace {

/// Fontconfig takes the first installed one, and any other font for missing characters.
constexpr const char* families = "Liberation Sans, Arial, Helvetica, DejaVu Sans, sans-serif";

struct Unreference {
  void operator()(void* object) const { g_object_unref(object); }
};
using Layout = std::unique_ptr<PangoLayout, Unreference>;

/// One for all texts. Widths and positions of letters are not rounded to pixels, so that a line has the same width in
/// all formats, in proportion to its size.
PangoContext* context() {
  static PangoContext* const made = [] {
    PangoFontMap* fonts = pango_cairo_font_map_new();
    pango_cairo_font_map_set_resolution(PANGO_CAIRO_FONT_MAP(fonts), 72); // 1 pt = 1 pixel
    PangoContext* result = pango_font_map_create_context(fonts);
    pango_context_set_round_glyph_positions(result, FALSE);
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(result, options);
    cairo_font_options_destroy(options);
    PangoFontDescription* font = pango_font_description_from_string(families);
    pango_context_set_font_description(result, font);
    pango_font_description_free(font);
    return result;
  }();
  return made;
}

void add_attribute(PangoAttrList* list, PangoAttribute* attribute, std::size_t from, std::size_t to) {
  attribute->start_index = static_cast<guint>(from);
  attribute->end_index = static_cast<guint>(to);
  pango_attr_list_insert(list, attribute);
}

int in_pango(double pixels) {
  return pango_units_from_double(pixels);
}

/// The line with superscripts and subscripts.
Layout lay_out(const std::string& utf8, double size) {
  Layout layout(pango_layout_new(context()));
  std::string whole;
  PangoAttrList* attributes = pango_attr_list_new();
  for (const TextRun& run : text_runs(utf8)) {
    const std::size_t from = whole.size();
    whole += run.string;
    add_attribute(attributes, pango_attr_size_new_absolute(in_pango(size * run_size(run.level))), from, whole.size());
    if (run.level != 0)
      add_attribute(attributes, pango_attr_rise_new(in_pango(size * run_rise(run.level))), from, whole.size());
  }
  pango_layout_set_single_paragraph_mode(layout.get(), TRUE);
  pango_layout_set_text(layout.get(), whole.data(), static_cast<int>(whole.size()));
  pango_layout_set_attributes(layout.get(), attributes);
  pango_attr_list_unref(attributes);
  return layout;
}

double width_of(PangoLayout* layout) {
  PangoRectangle box;
  pango_layout_get_extents(layout, nullptr, &box);
  return pango_units_to_double(box.width);
}

/// The Debian package with a font that probably has a character.
const char* package_for(char32_t p) {
  const bool eastern = (p >= 0x2E80 && p <= 0x9FFF) || (p >= 0xAC00 && p <= 0xD7AF) || (p >= 0xF900 && p <= 0xFAFF) ||
                       (p >= 0xFF00 && p <= 0xFFEF) || (p >= 0x20000 && p <= 0x3FFFF);
  if (eastern) return "fonts-noto-cjk";
  return p < 0x2000 ? "fonts-dejavu-core" : "fonts-noto-core";
}

/// Warns of characters without a font.
void warn_of_missing(const std::string& utf8) {
  std::vector<std::string> characters, packages;
  for (char32_t point : code_points(utf8)) {
    const std::string sign = to_utf8(point);
    if (point <= 0x7E || point == 0xFFFD || std::count(characters.begin(), characters.end(), sign) > 0) continue;
    if (pango_layout_get_unknown_glyphs_count(lay_out(sign, 100).get()) == 0) continue;
    characters.push_back(sign);
    const std::string package = package_for(point);
    if (std::count(packages.begin(), packages.end(), package) == 0) packages.push_back(package);
  }
  if (!characters.empty())
    warn("view.text.no_font", {{"characters", characters}, {"text", utf8}, {"packages", packages}});
}

} // namespace

double width_of(const std::string& utf8, double size) {
  constexpr double measured = 100;
  constexpr std::size_t most = 10'000; // bounds the memory of the cache, e.g. for titles of a film
  static std::unordered_map<std::string, double> known;
  if (known.size() > most) known.clear();
  const auto [found, fresh] = known.try_emplace(utf8, 0);
  if (fresh) found->second = width_of(lay_out(utf8, measured).get()) / measured;
  return found->second * size;
}

void draw_text(cairo_t* paper, const Text& text, double height) {
  warn_of_broken(text.string);
  const Layout layout = lay_out(text.string, text.size);
  if (pango_layout_get_unknown_glyphs_count(layout.get()) > 0) warn_of_missing(text.string);
  const double width = width_of(text.string, text.size);
  const double shift = text.align == Align::left ? 0 : text.align == Align::center ? 0.5 * width : width;
  cairo_save(paper);
  cairo_translate(paper, text.at[0], height - text.at[1]);
  if (text.upright) cairo_rotate(paper, -G_PI_2);
  cairo_move_to(paper, -shift, 0);
  cairo_set_source_rgb(paper, text.color[0] / 255.0, text.color[1] / 255.0, text.color[2] / 255.0);
  pango_cairo_show_layout_line(paper, pango_layout_get_line_readonly(layout.get(), 0));
  cairo_restore(paper);
}

} // namespace signorini::view
