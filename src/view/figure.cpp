#include "view/figure.hpp"

#include "base/error.hpp"
#include "os/limits.hpp"
#include "os/module.hpp"
#include "os/parallel.hpp"
#include "view/text.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>

namespace signorini::view {
namespace {

// Bytes that a drawing by Cairo and Pango and an image by VTK and Mesa need at most, measured, and those per pixel of
// the image and of the copy in a file; GLib and Mesa end the process when an allocation fails.
constexpr double drawing_memory = 32 << 20, image_memory = 128 << 20, pixel_memory = 8;

/// The function table that a module exports under a name.
template <class Table> const Table& table_of(const char* module, const char* name) {
  const std::filesystem::path file = find_module(module);
  const auto [first, second] = module_folders();
  require(!file.empty(), "view.module.missing",
          {{"module", module}, {"first", first.string()}, {"second", second.string()}});
  return *static_cast<const Table*>(load_module(file, name));
}

} // namespace

Figure figure_of(Plate plate) {
  Figure figure{plate.drawing.size, {}};
  figure.plates.push_back({{0, 0}, std::move(plate)});
  return figure;
}

std::string file_ending(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

Format format_of(const std::string& file) {
  const std::string ending = file_ending(file);
  if (ending == ".png") return Format::png;
  if (ending == ".svg") return Format::svg;
  if (ending == ".pdf") return Format::pdf;
  fail("view.file.ending", {{"file", file}});
}

FileKind kind_of(Format format) {
  return format == Format::png ? FileKind::png : format == Format::svg ? FileKind::svg : FileKind::pdf;
}

std::string bytes_of(const Figure& figure, Format format, bool transparent) {
  demand_memory(drawing_memory);
  const MemoryReserve reserve;
  return flat_renderer().bytes(figure, format, transparent, image_of);
}

const Renderer& renderer() {
  static const Renderer& loaded = []() -> const Renderer& {
    // Mesa's rasterizer without threads: a study's cases are forked from this process and would wait there for threads
    // that exist only in their parent. Drawing takes the same time.
    ::setenv("LP_NUM_THREADS", "0", 0);
    return table_of<Renderer>("signorini_view.so", "signorini_renderer");
  }();
  return loaded;
}

const FlatRenderer& flat_renderer() {
  static const FlatRenderer& loaded = []() -> const FlatRenderer& {
    check_threads(); // Pango starts one and ends the program if it cannot
    const auto& table = table_of<FlatRenderer>("signorini_flat.so", "signorini_flat");
    *table.warning_sink = warning_sink;
    return table;
  }();
  return loaded;
}

double text_width(std::string_view utf8, double size) {
  const MemoryReserve reserve;
  return flat_renderer().text_width(std::string(utf8), size);
}

Pixels image_of(const Plate& plate, int scale, bool transparent) {
  const double pixels = 1.0 * scale * scale * plate.drawing.size[0] * plate.drawing.size[1];
  demand_memory(image_memory + pixel_memory * pixels);
  const MemoryReserve reserve;
  return renderer().image(plate, scale, transparent);
}

} // namespace signorini::view
