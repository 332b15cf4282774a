#include "base/text.hpp"
#include "terminal/art/image.hpp"
#include "terminal/art/parts.hpp"
#include "terminal/character_art.hpp"

#include <chafa.h>
#include <cstdlib>
#include <memory>
#include <sixel.h>

namespace signorini::terminal {
namespace {

template <auto release> struct Released {
  template <class T> void operator()(T* object) const { release(object); }
};
using Config = std::unique_ptr<ChafaCanvasConfig, Released<chafa_canvas_config_unref>>;
using Canvas = std::unique_ptr<ChafaCanvas, Released<chafa_canvas_unref>>;
using Terminal = std::unique_ptr<ChafaTermInfo, Released<chafa_term_info_unref>>;
using Symbols = std::unique_ptr<ChafaSymbolMap, Released<chafa_symbol_map_unref>>;
using Text = std::unique_ptr<GString, decltype([](GString* text) { g_string_free(text, TRUE); })>;

std::string description() {
  return text("Chafa ", CHAFA_MAJOR_VERSION, ".", CHAFA_MINOR_VERSION, ".", CHAFA_MICRO_VERSION, ", libsixel ",
              LIBSIXEL_VERSION);
}

/// What Chafa knows of the terminal that the environment names.
Terminal named_terminal() {
  gchar** environment = g_get_environ();
  Terminal terminal(chafa_term_db_detect(chafa_term_db_get_default(), environment));
  g_strfreev(environment);
  return terminal;
}

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

/// The most colors that a terminal has. Chafa expects 24 bits of every xterm-256color, a name that terminals with 256
/// colors have, too.
ChafaCanvasMode colors_of(ChafaTermInfo* terminal) {
  const std::string colors = variable("COLORTERM");
  const bool direct = colors == "truecolor" || colors == "24bit" || !variable("TERM").ends_with("256color");
  const auto has = [&](ChafaTermSeq sequence) { return chafa_term_info_have_seq(terminal, sequence) != 0; };
  if (direct && has(CHAFA_TERM_SEQ_SET_COLOR_FGBG_DIRECT)) return CHAFA_CANVAS_MODE_TRUECOLOR;
  if (has(CHAFA_TERM_SEQ_SET_COLOR_FGBG_256)) return CHAFA_CANVAS_MODE_INDEXED_240; // users redefine the first 16
  if (has(CHAFA_TERM_SEQ_SET_COLOR_FGBG_16)) return CHAFA_CANVAS_MODE_INDEXED_16;
  if (has(CHAFA_TERM_SEQ_SET_COLOR_FGBG_8)) return CHAFA_CANVAS_MODE_INDEXED_8;
  return CHAFA_CANVAS_MODE_FGBG_BGFG;
}

std::string blocks(const std::string& png, int columns, int rows) {
  const Image image = decoded(png, 4); // Chafa 1.12 needs rows at multiples of 4 bytes
  const Terminal terminal = named_terminal();
  const Symbols symbols(chafa_symbol_map_new());
  chafa_symbol_map_add_by_tags(symbols.get(), CHAFA_SYMBOL_TAG_SPACE);
  chafa_symbol_map_add_by_tags(symbols.get(), CHAFA_SYMBOL_TAG_VHALF);
  const Config config(chafa_canvas_config_new());
  chafa_canvas_config_set_geometry(config.get(), columns, rows);
  chafa_canvas_config_set_canvas_mode(config.get(), colors_of(terminal.get()));
  chafa_canvas_config_set_symbol_map(config.get(), symbols.get());
  const Canvas canvas(chafa_canvas_new(config.get()));
  chafa_canvas_draw_all_pixels(canvas.get(), CHAFA_PIXEL_RGB8, image.pixels.data(), image.width, image.height,
                               image.stride);
  chafa_term_info_supplement(terminal.get(), chafa_term_db_get_fallback_info(chafa_term_db_get_default()));
  const Text printed(chafa_canvas_print(canvas.get(), terminal.get()));
  return {printed->str, printed->len};
}

} // namespace
} // namespace signorini::terminal

extern "C" const signorini::terminal::CharacterArt signorini_terminal = {
    signorini::terminal::description, signorini::terminal::sixels, signorini::terminal::blocks};
