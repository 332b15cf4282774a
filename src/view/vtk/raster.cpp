// The module's entry: a Raster through VTK and OpenGL into the bytes of a PNG file.

#include "base/error.hpp"
#include "view/renderer.hpp"
#include "view/vtk/film.hpp"
#include "view/vtk/glyphs.hpp"
#include "view/vtk/relief_actors.hpp"
#include "view/vtk/window.hpp"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
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

constexpr int supersampling = 3; // rendered this many times larger each way, then averaged: smooth edges

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

vtkSmartPointer<vtkActor> triangles_actor(const Raster& raster) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  // Later triangles lie nearer to the eye, all of them between the fields at 0 and 1.
  const double step = 1.0 / static_cast<double>(raster.colours.size());
  double height = step;
  for (std::size_t t = 0; t < raster.colours.size(); ++t) {
    if (t > 0 && raster.colours[t] != raster.colours[t - 1]) height += step;
    for (int c = 0; c < 3; ++c)
      points->InsertNextPoint(raster.corners[3 * t + c][0], raster.corners[3 * t + c][1], height);
    const auto first = static_cast<vtkIdType>(3 * t);
    cells->InsertNextCell({first, first + 1, first + 2});
    colours->InsertNextTypedTuple(raster.colours[t].data());
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetCellData()->SetScalars(colours);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  return flat_actor(*mapper);
}

/// A part without its texts.
vtkSmartPointer<vtkRenderer> renderer_of(const Raster& raster, double ground) {
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(ground, ground, ground);
  add_relief(*renderer, raster.relief);
  for (const Field& field : raster.fields) renderer->AddActor(field_actor(field));
  if (!raster.colours.empty()) renderer->AddActor(triangles_actor(raster));
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(0.5 * raster.size[0], 0.5 * raster.size[1], 0);
  camera->SetPosition(0.5 * raster.size[0], 0.5 * raster.size[1], 10);
  camera->SetParallelScale(0.5 * raster.size[1]);
  camera->SetClippingRange(8, 11);
  return renderer;
}

/// Draws everything but text, at the larger size, on ground of this grey; returns red, green, blue, opacity per pixel,
/// rows from the bottom up.
vtkUnsignedCharArray& render(const Image& image, double ground) {
  const std::array<int, 2> size = {supersampling * image.size[0], supersampling * image.size[1]};
  vtkRenderWindow& window = offscreen_window(size);
  window.SetMultiSamples(0);
  std::vector<vtkSmartPointer<vtkRenderer>> renderers;
  // Renderers erase their own part of the window only: what no part covers is this one's.
  if (image.parts.size() > 1) renderers.push_back(renderer_of({image.size, {}, {}, {}, {}, {}}, ground));
  for (const auto& [at, raster] : image.parts) {
    renderers.push_back(renderer_of(raster, ground));
    const double width = image.size[0], height = image.size[1];
    renderers.back()->SetViewport(at[0] / width, at[1] / height, (at[0] + raster.size[0]) / width,
                                  (at[1] + raster.size[1]) / height);
  }
  for (const auto& renderer : renderers) window.AddRenderer(renderer);
  window.Render();
  // Kept from picture to picture: fresh pages for so many pixels cost as much as drawing them.
  static vtkNew<vtkUnsignedCharArray> pixels;
  const int failed = window.GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  for (const auto& renderer : renderers) window.RemoveRenderer(renderer);
  require(failed != VTK_ERROR && pixels->GetNumberOfValues() == vtkIdType(4) * size[0] * size[1],
          "OpenGL did not draw a picture of ", image.size[0], " × ", image.size[1], " pixels; choose a smaller size");
  return *pixels.Get();
}

/// The mean over squares of pixels.
Pixels shrink(vtkUnsignedCharArray& large, const std::array<int, 2>& size) {
  constexpr int n = supersampling;
  const int width = size[0], height = size[1];
  Pixels small{size, std::vector<std::uint8_t>(std::size_t(3) * width * height)};
  std::vector<int> sums(std::size_t(3) * width);
  for (int y = 0; y < height; ++y) {
    std::fill(sums.begin(), sums.end(), 0);
    for (int j = 0; j < n; ++j) {
      const std::uint8_t* row = large.GetPointer(vtkIdType(4) * n * width * (n * y + j));
      for (int x = 0; x < width; ++x)
        for (int i = 0; i < n; ++i)
          for (int c = 0; c < 3; ++c) sums[3 * x + c] += row[4 * (n * x + i) + c];
    }
    std::transform(sums.begin(), sums.end(), &small.rgb[std::size_t(3) * width * y],
                   [](int sum) { return static_cast<std::uint8_t>((sum + n * n / 2) / (n * n)); });
  }
  return small;
}

std::string encode(const std::array<int, 2>& size, int components, const std::vector<std::uint8_t>& bytes) {
  vtkNew<vtkImageData> data;
  data->SetDimensions(size[0], size[1], 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  std::copy(bytes.begin(), bytes.end(), static_cast<std::uint8_t*>(data->GetScalarPointer()));
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(data);
  writer->WriteToMemoryOn();
  writer->Write();
  const vtkUnsignedCharArray& result = *writer->GetResult();
  return {reinterpret_cast<const char*>(const_cast<vtkUnsignedCharArray&>(result).GetPointer(0)),
          static_cast<std::size_t>(result.GetNumberOfValues())};
}

bool covers(const PlacedRaster& part, const Vec2& at) {
  const double x = at[0] - part.at[0], y = at[1] - part.at[1];
  return x >= 0 && x <= part.raster.size[0] && y >= 0 && y <= part.raster.size[1];
}

Pixels draw(const Image& image, double ground) {
  Pixels pixels = shrink(render(image, ground), image.size);
  for (auto part = image.parts.begin(); part != image.parts.end(); ++part)
    for (Text text : part->raster.texts) {
      text.at = {text.at[0] + part->at[0], text.at[1] + part->at[1]};
      // What begins beneath a later part goes with what it stands at.
      if (std::none_of(part + 1, image.parts.end(), [&](const PlacedRaster& later) { return covers(later, text.at); }))
        draw_text(pixels, text);
    }
  return pixels;
}

/// Red, green, blue, opacity of what looks one way on white and the other on black: white − black = 255 (1 − opacity).
std::vector<std::uint8_t> see_through(const Pixels& white, const Pixels& black) {
  std::vector<std::uint8_t> rgba;
  rgba.reserve(black.rgb.size() / 3 * 4);
  for (std::size_t i = 0; i < black.rgb.size(); i += 3) {
    int ground = 255;
    for (std::size_t c = 0; c < 3; ++c) ground = std::min(ground, white.rgb[i + c] - black.rgb[i + c]);
    const int opacity = 255 - std::max(0, ground);
    for (std::size_t c = 0; c < 3; ++c)
      rgba.push_back(static_cast<std::uint8_t>(opacity ? std::min(255, 255 * black.rgb[i + c] / opacity) : 0));
    rgba.push_back(static_cast<std::uint8_t>(opacity));
  }
  return rgba;
}

std::string draw_png(const Image& image) {
  const Pixels white = draw(image, 1);
  if (!image.transparent) return encode(image.size, 3, white.rgb);
  return encode(image.size, 4, see_through(white, draw(image, 0)));
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

extern "C" const signorini::view::Renderer signorini_renderer = {signorini::view::draw_png,
#ifdef SIGNORINI_VTK_HAS_THEORA
                                                                 signorini::view::draw_ogv,
#else
                                                                 nullptr,
#endif
                                                                 signorini::view::describe};
