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

/// A renderer of the part [left, right, bottom, top] of a window in its pixels, with `larger` pixels per pixel of the
/// drawing.
vtkSmartPointer<vtkRenderer> renderer_of(const Box& part, const std::array<int, 2>& window, int larger,
                                         bool transparent) {
  const auto& [left, right, bottom, top] = part;
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  const double background = transparent ? 0 : 1; // black, so that colors are premultiplied by alpha
  renderer->SetBackground(background, background, background);
  renderer->SetBackgroundAlpha(background);
  renderer->SetViewport(left / window[0], bottom / window[1], right / window[0], top / window[1]);
  const double x = 0.5 * (left + right) / larger, y = 0.5 * (bottom + top) / larger;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(x, y, 0);
  camera->SetPosition(x, y, 10);
  camera->SetParallelScale(0.5 * (top - bottom) / larger);
  camera->SetClippingRange(8, 11);
  return renderer;
}

/// Draws the relief of a plate, `larger` times its size, on white or transparent background; returns red, green, blue,
/// alpha per pixel, rows from the bottom up.
vtkUnsignedCharArray& render(const Plate& plate, int larger, bool transparent) {
  const std::array<int, 2> size = {larger * plate.drawing.size[0], larger * plate.drawing.size[1]};
  vtkRenderWindow& window = offscreen_window(size);
  window.SetMultiSamples(0);
  const auto pixel = [&](double at, int axis) { return std::clamp(std::round(larger * at), 0.0, 1.0 * size[axis]); };
  const Box whole = {0, 1.0 * size[0], 0, 1.0 * size[1]};
  std::vector<vtkSmartPointer<vtkRenderer>> renderers = {renderer_of(whole, size, larger, transparent)};
  for (const Relief& relief : plate.reliefs) {
    const auto& [left, right, bottom, top] = relief.window;
    const Box part = {pixel(left, 0), pixel(right, 0), pixel(bottom, 1), pixel(top, 1)};
    if (part[0] >= part[1] || part[2] >= part[3]) continue;
    renderers.push_back(renderer_of(part, size, larger, transparent));
    add_relief(*renderers.back(), relief);
  }
  for (const auto& renderer : renderers) window.AddRenderer(renderer);
  window.Render();
  // Reused, because allocating so many pixels takes as long as drawing them.
  static vtkNew<vtkUnsignedCharArray> pixels;
  const int failed = window.GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  for (const auto& renderer : renderers) window.RemoveRenderer(renderer);
  require(failed != VTK_ERROR && pixels->GetNumberOfValues() == vtkIdType(4) * size[0] * size[1], "view.opengl.image",
          {{"width", plate.drawing.size[0]}, {"height", plate.drawing.size[1]}});
  return *pixels.Get();
}

/// The average over squares of n × n pixels, rows from the top.
Pixels shrink(vtkUnsignedCharArray& large, const std::array<int, 2>& size, int n) {
  const int width = size[0], height = size[1];
  Pixels small{size, {}};
  small.argb.reserve(std::size_t(width) * height);
  std::vector<std::array<std::uint32_t, 4>> sums(width);
  for (int y = height; y-- > 0;) {
    std::fill(sums.begin(), sums.end(), std::array<std::uint32_t, 4>{});
    for (int j = 0; j < n; ++j) {
      const std::uint8_t* pixel = large.GetPointer(vtkIdType(4) * n * width * (n * y + j));
      for (auto& sum : sums)
        for (int i = 0; i < n; ++i, pixel += 4)
          for (int c = 0; c < 4; ++c) sum[c] += pixel[c];
    }
    for (const auto& sum : sums) {
      const auto mean = [&](int c) { return (sum[c] + n * n / 2) / (n * n); };
      small.argb.push_back(mean(3) << 24 | mean(0) << 16 | mean(1) << 8 | mean(2));
    }
  }
  return small;
}

Pixels image(const Plate& plate, int scale, bool transparent) {
  const int n = supersampling(scale);
  return shrink(render(plate, n * scale, transparent), {scale * plate.drawing.size[0], scale * plate.drawing.size[1]},
                n);
}

std::string describe() {
  vtkRenderWindow& window = offscreen_window({16, 16});
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
