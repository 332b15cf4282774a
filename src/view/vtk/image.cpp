// Entry of the module: draws fields and surfaces by VTK and OpenGL into pixels.

#include "base/error.hpp"
#include "view/vtk/parts.hpp"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVersion.h>

#include <algorithm>
#include <cmath>

namespace signorini::view {
namespace {

/// Supersampling factor in each direction, for smooth edges.
int supersampling(int scale) {
  return scale == 1 ? 3 : 2;
}

/// A renderer of one relief or of the background, and its part [left, right, bottom, top] of the enlarged plate.
struct Layer {
  vtkSmartPointer<vtkRenderer> renderer;
  Box part;
};

/// An image that is drawn by tiles of one size into one window: VTK and Mesa allocate and clear all buffers again
/// whenever a window has another size, which takes longer than drawing.
struct Canvas {
  const Plate& plate;
  bool transparent;
  int shrunk, larger; ///< pixels of the window per pixel of the image, and of the drawing, in each direction
  std::vector<Layer> layers = {};
  Pixels image = {};

  ~Canvas() {
    for (const Layer& layer : layers) offscreen_window().RemoveRenderer(layer.renderer);
  }
  void add_layer(const Box& part, const Relief* relief);
  void draw_tile(const std::array<int, 2>& at);
  void shrink(vtkUnsignedCharArray& large, const std::array<int, 2>& at, const std::array<int, 2>& size);
};

void Canvas::add_layer(const Box& part, const Relief* relief) {
  if (part[0] >= part[1] || part[2] >= part[3]) return;
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  const double background = transparent ? 0 : 1; // black, so that colors are premultiplied by alpha
  renderer->SetBackground(background, background, background);
  renderer->SetBackgroundAlpha(background);
  if (relief != nullptr) add_relief(*renderer, *relief);
  layers.push_back({renderer, part});
  offscreen_window().AddRenderer(renderer);
}

/// Draws the layers that the tile from this pixel of the image touches; without reliefs there it keeps its background.
void Canvas::draw_tile(const std::array<int, 2>& at) {
  const double left = shrunk * at[0], bottom = shrunk * at[1];
  const Box tile = {left, std::min(left + tile_size, 1.0 * shrunk * image.size[0]), bottom,
                    std::min(bottom + tile_size, 1.0 * shrunk * image.size[1])};
  int reliefs = -1; // without the background
  for (const auto& [renderer, whole] : layers) {
    const Box part = {std::max(whole[0], tile[0]), std::min(whole[1], tile[1]), std::max(whole[2], tile[2]),
                      std::min(whole[3], tile[3])};
    const bool drawn = part[0] < part[1] && part[2] < part[3];
    renderer->SetDraw(drawn);
    if (!drawn) continue;
    ++reliefs;
    renderer->SetViewport((part[0] - left) / tile_size, (part[2] - bottom) / tile_size, (part[1] - left) / tile_size,
                          (part[3] - bottom) / tile_size);
    const double x = 0.5 * (part[0] + part[1]) / larger, y = 0.5 * (part[2] + part[3]) / larger;
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(x, y, 0);
    camera->SetPosition(x, y, 10);
    camera->SetParallelScale(0.5 * (part[3] - part[2]) / larger);
    camera->SetClippingRange(8, 11);
  }
  if (reliefs == 0) return;
  vtkRenderWindow& window = offscreen_window();
  window.Render();
  const std::array<int, 2> size = {int(tile[1] - left), int(tile[3] - bottom)};
  // Reused, because allocating so many pixels takes as long as drawing them.
  static vtkNew<vtkUnsignedCharArray> pixels;
  const int failed = window.GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  require(failed != VTK_ERROR && pixels->GetNumberOfValues() == vtkIdType(4) * size[0] * size[1], "view.opengl.image",
          {{"width", plate.drawing.size[0]}, {"height", plate.drawing.size[1]}});
  shrink(*pixels.Get(), at, {size[0] / shrunk, size[1] / shrunk});
}

/// Sets pixels of the image to averages over squares of pixels, whose rows come from the bottom up.
void Canvas::shrink(vtkUnsignedCharArray& large, const std::array<int, 2>& at, const std::array<int, 2>& size) {
  const std::uint32_t n = shrunk, area = n * n;
  std::vector<std::array<std::uint32_t, 4>> sums(size[0]);
  for (int y = 0; y < size[1]; ++y) {
    std::fill(sums.begin(), sums.end(), std::array<std::uint32_t, 4>{});
    const std::uint8_t* pixel = large.GetPointer(vtkIdType(4) * area * size[0] * y);
    for (std::uint32_t j = 0; j < n; ++j)
      for (auto& sum : sums)
        for (std::uint32_t i = 0; i < n; ++i, pixel += 4)
          for (int c = 0; c < 4; ++c) sum[c] += pixel[c];
    std::uint32_t* row = &image.argb[std::size_t(image.size[0]) * (image.size[1] - 1 - at[1] - y) + at[0]];
    for (const auto& sum : sums) {
      const auto mean = [&](int c) { return (sum[c] + area / 2) / area; };
      *row++ = mean(3) << 24 | mean(0) << 16 | mean(1) << 8 | mean(2);
    }
  }
}

Pixels image(const Plate& plate, int scale, bool transparent) {
  const int n = supersampling(scale);
  Canvas canvas{plate, transparent, n, n * scale};
  Pixels& image = canvas.image;
  image.size = {scale * plate.drawing.size[0], scale * plate.drawing.size[1]};
  image.argb.assign(std::size_t(image.size[0]) * image.size[1], transparent ? 0 : 0xffffffff);
  const Box whole = {0, 1.0 * n * image.size[0], 0, 1.0 * n * image.size[1]};
  canvas.add_layer(whole, nullptr);
  const auto pixel = [&](double at, int axis) {
    return std::clamp(std::round(canvas.larger * at), 0.0, whole[2 * axis + 1]);
  };
  for (const Relief& relief : plate.reliefs) {
    const auto& [left, right, bottom, top] = relief.window;
    canvas.add_layer({pixel(left, 0), pixel(right, 0), pixel(bottom, 1), pixel(top, 1)}, &relief);
  }
  for (int y = 0; y < image.size[1]; y += tile_size / n)
    for (int x = 0; x < image.size[0]; x += tile_size / n) canvas.draw_tile({x, y});
  return std::move(image);
}

std::string describe() {
  vtkRenderWindow& window = offscreen_window();
  window.Render();
  const std::string report = window.ReportCapabilities();
  const auto value = [&](const std::string& key) {
    const std::size_t at = report.find(key);
    if (at == std::string::npos) return std::string("unknown");
    const std::size_t start = report.find_first_not_of(' ', at + key.size());
    return report.substr(start, report.find('\n', start) - start);
  };
  return std::string("VTK ") + vtkVersion::GetVTKVersion() + ", " + value("OpenGL renderer string:") + ", OpenGL " +
         value("OpenGL version string:");
}

} // namespace
} // namespace signorini::view

extern "C" const signorini::view::Renderer signorini_renderer = {signorini::view::image, signorini::view::describe};
