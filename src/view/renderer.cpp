#include "view/renderer.hpp"

#include "base/error.hpp"
#include "view/module.hpp"

#include <cstdlib>

namespace signorini::view {
namespace {

const Renderer& renderer() {
  static const Renderer* const loaded = [] {
    // Mesa's rasteriser without threads of its own: a study's cases are forked from this process, and there they would
    // wait for threads that only their parent has. Pictures take as long.
    ::setenv("LP_NUM_THREADS", "0", 0);
    return static_cast<const Renderer*>(module_table("signorini_view.so", "signorini_renderer"));
  }();
  return *loaded;
}

} // namespace

Pixels image_of(const Plate& plate, int scale, bool transparent) {
  return renderer().image(plate, scale, transparent);
}

void write_ogv(const std::string& file, int count, int rate, const PictureMaker& png) {
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
