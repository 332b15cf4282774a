#include "view/vtk/glyphs.hpp"

#include "base/error.hpp"
#include "view/text.hpp"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace signorini::view {
namespace {

constexpr int pixels_per_inch = 72; // VTK's sizes are points: one point, one pixel

/// VTK's own letters lack Greek. Liberation Sans has Helvetica's widths; the others are set smaller to come near them.
struct Font {
  const char* file; // null: VTK's own
  double scale;
};

constexpr Font fonts[] = {{"/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf", 1.0},
                          {"/usr/share/fonts/truetype/liberation2/LiberationSans-Regular.ttf", 1.0},
                          {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", 0.88},
                          {nullptr, 0.9}};

vtkSmartPointer<vtkTextProperty> style_of(const Font& font, double size) {
  auto style = vtkSmartPointer<vtkTextProperty>::New();
  style->SetColor(1, 1, 1);
  style->SetFontSize(std::max(1, static_cast<int>(std::lround(size * font.scale))));
  if (font.file != nullptr) {
    style->SetFontFamily(VTK_FONT_FILE);
    style->SetFontFile(font.file);
  } else {
    style->SetFontFamilyToArial();
  }
  return style;
}

/// A character that a font lacks takes no room.
bool shows(const Font& font, char32_t point) {
  int box[4] = {0, 0, 0, 0};
  vtkTextRenderer::GetInstance()->GetBoundingBox(style_of(font, 100), to_utf8(point), box, pixels_per_inch,
                                                 vtkTextRenderer::FreeType);
  return box[1] > box[0] + 1;
}

/// The first font that is there and shows all of the text.
const Font& font_for(const std::string& utf8) {
  char32_t missing = 0;
  for (const Font& font : fonts) {
    if (font.file != nullptr && !std::filesystem::exists(font.file)) continue;
    const auto points = code_points(utf8);
    const auto lacking =
        std::find_if(points.begin(), points.end(), [&](char32_t p) { return p > 0x7E && !shows(font, p); });
    if (lacking == points.end()) return font;
    if (missing == 0) missing = *lacking;
  }
  fail("no installed font shows '", to_utf8(missing), "' of the text '", utf8,
       "'; use other words, or install fonts-liberation and fonts-dejavu-core");
}

/// A run's coverage (0 … 255), rows from the bottom up, and where it goes.
struct Glyphs {
  int width = 0, height = 0;
  std::vector<std::uint8_t> coverage;
  int descent = 0; // rows below the baseline
};

Glyphs rasterise(const std::string& utf8, double size) {
  Glyphs glyphs;
  const auto style = style_of(font_for(utf8), size);
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  renderer->SetScaleToPowerOfTwo(false);
  vtkNew<vtkImageData> image;
  vtkTextRenderer::Metrics metrics;
  int used[2] = {0, 0};
  if (!renderer->GetMetrics(style, utf8, metrics, pixels_per_inch, vtkTextRenderer::FreeType) ||
      !renderer->RenderString(style, utf8, image, used, pixels_per_inch, vtkTextRenderer::FreeType))
    return glyphs;
  glyphs.width = used[0];
  glyphs.height = used[1];
  glyphs.descent = -metrics.Descent[1];
  for (int y = 0; y < used[1]; ++y)
    for (int x = 0; x < used[0]; ++x)
      glyphs.coverage.push_back(static_cast<const std::uint8_t*>(
          image->GetScalarPointer(image->GetExtent()[0] + x, image->GetExtent()[2] + y, 0))[3]);
  return glyphs;
}

/// A line of text at a size, run by run.
struct Line {
  std::vector<Glyphs> runs;
  std::vector<int> rises;
  int width = 0;
};

Line rasterise_line(const std::string& utf8, double size) {
  Line line;
  for (const TextRun& run : text_runs(utf8)) {
    line.runs.push_back(rasterise(run.string, size * run_size(run.level)));
    line.rises.push_back(static_cast<int>(std::lround(size * run_rise(run.level))));
    line.width += line.runs.back().width;
  }
  return line;
}

/// No longer than the layout takes it to be: sizes are whole pixels, and small letters stand on whole pixels.
Line fitting_line(const Text& text) {
  const double most = 1.01 * text_width(text.string, text.size) + 1;
  Line line = rasterise_line(text.string, text.size);
  for (double size = text.size - 1; line.width > most && size > 1; --size) line = rasterise_line(text.string, size);
  return line;
}

} // namespace

void draw_text(Pixels& image, const Text& text) {
  const auto [runs, rises, width] = fitting_line(text);
  const int shift = text.align == Align::left ? 0 : text.align == Align::centre ? width / 2 : width;
  int along = -shift;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    for (int j = 0; j < runs[r].height; ++j)
      for (int i = 0; i < runs[r].width; ++i) {
        const int u = along + i, v = rises[r] - runs[r].descent + j; // along and across the line of text
        const int x = static_cast<int>(std::lround(text.at[0])) + (text.upright ? -v : u);
        const int y = static_cast<int>(std::lround(text.at[1])) + (text.upright ? u : v);
        if (x < 0 || y < 0 || x >= image.size[0] || y >= image.size[1]) continue;
        const int cover = runs[r].coverage[std::size_t(j) * runs[r].width + i];
        std::uint8_t* pixel = &image.rgb[3 * (std::size_t(y) * image.size[0] + x)];
        for (int c = 0; c < 3; ++c)
          pixel[c] = static_cast<std::uint8_t>((pixel[c] * (255 - cover) + text.colour[c] * cover + 127) / 255);
      }
    along += runs[r].width;
  }
}

} // namespace signorini::view
