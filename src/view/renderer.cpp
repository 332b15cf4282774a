#include "view/renderer.hpp"

#include "base/error.hpp"
#include "view/strokes.hpp"
#include "view/text.hpp"

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>

namespace signorini::view {
namespace {

constexpr const char* module_name = "signorini_view.so";

/// The module stands in lib/signorini beside the program or beside the program's folder (bin, tests).
std::filesystem::path module_file() {
  const auto here = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  for (const auto& folder : {here / "lib/signorini", here.parent_path() / "lib/signorini"})
    if (std::filesystem::exists(folder / module_name)) return folder / module_name;
  fail("pictures need ", module_name, ", which is neither in ", (here / "lib/signorini").string(), " nor in ",
       (here.parent_path() / "lib/signorini").string(), "; build it or install the program as a whole");
}

const Renderer& renderer() {
  static const Renderer* const loaded = [] {
    const std::string file = module_file().string();
    // Mesa's rasteriser without threads of its own: a study's cases are forked from this process, and there they would
    // wait for threads that only their parent has. Pictures take as long.
    ::setenv("LP_NUM_THREADS", "0", 0);
    // Never unloaded: VTK's factories and Mesa's threads do not survive that.
    void* module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (module == nullptr) fail("cannot load ", file, " for pictures: ", ::dlerror());
    const auto* table = static_cast<const Renderer*>(::dlsym(module, "signorini_renderer"));
    require(table != nullptr, file, " is not Signorini's renderer; install the program as a whole");
    return table;
  }();
  return *loaded;
}

struct Collector {
  Raster& raster;

  void operator()(const Stroke& stroke) const { add(stroke_triangles(stroke), stroke.colour); }

  void operator()(const Fill& fill) const {
    std::vector<Vec2> corners;
    for (std::size_t i = 2; i < fill.outline.size(); ++i)
      corners.insert(corners.end(), {fill.outline[0], fill.outline[i - 1], fill.outline[i]});
    add(corners, fill.colour);
  }

  void operator()(const Text& text) const {
    warn_of_broken(text.string);
    raster.texts.push_back(text);
  }

  void add(const std::vector<Vec2>& corners, const Rgb& colour) const {
    raster.corners.insert(raster.corners.end(), corners.begin(), corners.end());
    raster.colours.insert(raster.colours.end(), corners.size() / 3, colour);
  }
};

} // namespace

Figure figure_of(Plate plate) {
  Figure figure{plate.drawing.size, {}};
  figure.plates.push_back({{0, 0}, std::move(plate)});
  return figure;
}

std::string png(Figure figure, bool transparent) {
  Image image{figure.size, {}, transparent};
  for (auto& [at, plate] : figure.plates) {
    Raster raster{plate.drawing.size, std::move(plate.relief), std::move(plate.fields), {}, {}, {}};
    for (const Mark& mark : plate.drawing.marks) std::visit(Collector{raster}, mark);
    image.parts.push_back({at, std::move(raster)});
  }
  return renderer().png(image);
}

std::string png(Plate plate, bool transparent) {
  return png(figure_of(std::move(plate)), transparent);
}

void write_ogv(const std::string& file, int count, int rate, const PngMaker& png) {
  require(has_theora(), "file '", file,
          "' needs a VTK with Theora, and this one was built without: write an .mp4 film ",
          "by ffmpeg, or a series of pictures, file = \"x-%04d.png\"");
  renderer().ogv(file, count, rate, png);
}

bool has_theora() {
  return renderer().ogv != nullptr;
}

std::string renderer_description() {
  return renderer().description();
}

} // namespace signorini::view
