// The module's entry: fields and surfaces through VTK and OpenGL into pixels.

#include "base/error.hpp"
#include "view/renderer.hpp"
#include "view/vtk/film.hpp"
#include "view/vtk/relief_actors.hpp"
#include "view/vtk/window.hpp"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVersion.h>

#include <algorithm>

namespace signorini::view {
namespace {

vtkSmartPointer<vtkActor> field_actor(const Field& field) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> values;
  for (std::size_t i = 0; i < field.points.size(); ++i) {
    points->InsertNextPoint(field.points[i][0], field.points[i][1], 0);
    values->InsertNextValue(static_cast<float>(field.values[i]));
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& t : field.triangles) cells->InsertNextCell({t[0], t[1], t[2]});
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetScalars(values);

  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  colour_by_value(*mapper, field.range, field.colours);
  return flat_actor(*mapper);
}

/// Rendered this many times larger each way, then averaged: smooth edges.
int supersampling(int scale) {
  return scale == 1 ? 3 : 2;
}

/// Draws what lies beneath a plate's marks, `larger` times its size, on ground of this grey; returns red, green, blue,
/// opacity per pixel, rows from the bottom up.
vtkUnsignedCharArray& render(const Plate& plate, int larger, double ground) {
  const double width = plate.drawing.size[0], height = plate.drawing.size[1];
  const std::array<int, 2> size = {larger * plate.drawing.size[0], larger * plate.drawing.size[1]};
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(ground, ground, ground);
  add_relief(*renderer, plate.relief);
  for (const Field& field : plate.fields) renderer->AddActor(field_actor(field));
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(0.5 * width, 0.5 * height, 0);
  camera->SetPosition(0.5 * width, 0.5 * height, 10);
  camera->SetParallelScale(0.5 * height);
  camera->SetClippingRange(8, 11);

  vtkRenderWindow& window = offscreen_window(size);
  window.SetMultiSamples(0);
  window.AddRenderer(renderer);
  window.Render();
  // Kept from picture to picture: fresh pages for so many pixels cost as much as drawing them.
  static vtkNew<vtkUnsignedCharArray> pixels;
  const int failed = window.GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  window.RemoveRenderer(renderer);
  require(failed != VTK_ERROR && pixels->GetNumberOfValues() == vtkIdType(4) * size[0] * size[1],
          "OpenGL did not draw a picture of ", width, " × ", height, " pixels; choose a smaller size");
  return *pixels.Get();
}

using Colours = std::vector<std::array<std::uint8_t, 3>>;

/// The mean over squares of n × n pixels, rows from the top.
Colours shrink(vtkUnsignedCharArray& large, const std::array<int, 2>& size, int n) {
  const int width = size[0], height = size[1];
  Colours small;
  small.reserve(std::size_t(width) * height);
  std::vector<std::array<int, 3>> sums(width);
  for (int y = height; y-- > 0;) {
    std::fill(sums.begin(), sums.end(), std::array<int, 3>{});
    for (int j = 0; j < n; ++j) {
      const std::uint8_t* pixel = large.GetPointer(vtkIdType(4) * n * width * (n * y + j));
      for (auto& sum : sums)
        for (int i = 0; i < n; ++i, pixel += 4)
          for (int c = 0; c < 3; ++c) sum[c] += pixel[c];
    }
    for (const auto& sum : sums) {
      const auto mean = [&](int c) { return static_cast<std::uint8_t>((sum[c] + n * n / 2) / (n * n)); };
      small.push_back({mean(0), mean(1), mean(2)});
    }
  }
  return small;
}

std::uint32_t argb(int opacity, const std::array<std::uint8_t, 3>& colour) {
  return std::uint32_t(opacity) << 24 | std::uint32_t(colour[0]) << 16 | std::uint32_t(colour[1]) << 8 | colour[2];
}

Pixels image(const Plate& plate, int scale, bool transparent) {
  const std::array<int, 2> size = {scale * plate.drawing.size[0], scale * plate.drawing.size[1]};
  const int n = supersampling(scale);
  const auto on_ground = [&](double ground) { return shrink(render(plate, n * scale, ground), size, n); };
  Pixels pixels{size, {}};
  pixels.argb.reserve(std::size_t(size[0]) * size[1]);
  const Colours white = on_ground(1);
  if (!transparent) {
    for (const auto& colour : white) pixels.argb.push_back(argb(255, colour));
    return pixels;
  }
  // On white minus on black is 255 (1 − opacity); on black colours are multiplied by the opacity.
  const Colours black = on_ground(0);
  for (std::size_t i = 0; i < black.size(); ++i) {
    int ground = 255;
    for (std::size_t c = 0; c < 3; ++c) ground = std::min(ground, std::max(0, white[i][c] - black[i][c]));
    pixels.argb.push_back(argb(255 - ground, black[i]));
  }
  return pixels;
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

extern "C" const signorini::view::Renderer signorini_renderer = {signorini::view::image,
#ifdef SIGNORINI_VTK_HAS_THEORA
                                                                 signorini::view::draw_ogv,
#else
                                                                 nullptr,
#endif
                                                                 signorini::view::describe};
