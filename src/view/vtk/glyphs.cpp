#include "view/vtk/glyphs.hpp"

#include "base/error.hpp"
#include "base/warning.hpp"
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
  const char* package; // of Debian
};

constexpr Font dejavu = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", 0.88, "fonts-dejavu-core"};
constexpr Font east = {"/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc", 0.95, "fonts-noto-cjk"};
constexpr Font signs = {"/usr/share/fonts/truetype/noto/NotoSansMath-Regular.ttf", 0.95, "fonts-noto-core"};
constexpr Font fonts[] = {
    {"/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf", 1.0, "fonts-liberation"},
    {"/usr/share/fonts/truetype/liberation2/LiberationSans-Regular.ttf", 1.0, "fonts-liberation2"},
    dejavu,
    east,
    signs,
    {nullptr, 0.9, ""}};

bool is_there(const Font& font) {
  return font.file == nullptr || std::filesystem::exists(font.file);
}

/// The package with the font, one of the above, that is likely to have a character; empty where it is there already.
std::string package_for(char32_t p) {
  // VTK draws nothing above U+FFFF.
  const bool eastern = (p >= 0x2E80 && p <= 0x9FFF) || (p >= 0xAC00 && p <= 0xD7AF) || (p >= 0xF900 && p <= 0xFAFF) ||
                       (p >= 0xFF00 && p <= 0xFFEF);
  const bool sign = p >= 0x2000 && p <= 0x2BFF;
  if (!eastern && !sign && p >= 0x2000) return "";
  const Font& font = eastern ? east : sign ? signs : dejavu;
  return is_there(font) ? "" : font.package;
}

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

/// The first font that is there and shows all of the points; null when none does.
const Font* font_with(const std::vector<char32_t>& points) {
  for (const Font& font : fonts)
    if (is_there(font) &&
        std::all_of(points.begin(), points.end(), [&](char32_t p) { return p <= 0x7E || shows(font, p); }))
      return &font;
  return nullptr;
}

/// Says which characters have boxes in their place, once for each text.
void warn_of(const std::vector<char32_t>& missing, const std::string& utf8) {
  std::string names, packages;
  for (char32_t point : missing) {
    if (point == 0xFFFD) continue;
    names += (names.empty() ? "'" : ", '") + to_utf8(point) + "'";
    const std::string package = package_for(point);
    if (!package.empty() && packages.find(package) == packages.npos)
      packages += (packages.empty() ? "" : " ") + package;
  }
  if (!names.empty())
    warn(text("no installed font shows ", names, " of the text '", utf8, "': boxes stand in the place; ",
              packages.empty() ? "use other words" : "apt install " + packages));
}

/// Stretches of a text with the font that each is drawn in. Where no font shows all, each character has its own, and
/// those that none shows become boxes.
struct Piece {
  std::string utf8;
  const Font* font;
};

/// `whole`: the line that the text belongs to, for the warning.
std::vector<Piece> pieces_of(const std::string& utf8, const std::string& whole) {
  const std::vector<char32_t> points = code_points(utf8);
  if (const Font* font = font_with(points)) return {{utf8, font}};
  std::vector<Piece> pieces;
  std::vector<char32_t> missing;
  for (char32_t point : points) {
    const Font* font = font_with({point});
    if (font == nullptr) missing.push_back(point);
    const Font* box = font != nullptr ? font : font_with({U'□'});
    Piece next{to_utf8(font != nullptr ? point : box != nullptr ? U'□' : U'?'), box != nullptr ? box : &fonts[0]};
    if (!pieces.empty() && pieces.back().font == next.font)
      pieces.back().utf8 += next.utf8;
    else
      pieces.push_back(std::move(next));
  }
  warn_of(missing, whole);
  return pieces;
}

/// A run's coverage (0 … 255), rows from the bottom up, and where it goes.
struct Glyphs {
  int width = 0, height = 0;
  std::vector<std::uint8_t> coverage;
  int descent = 0; // rows below the baseline
};

Glyphs rasterise(const std::string& utf8, const Font& font, double size) {
  Glyphs glyphs;
  const auto style = style_of(font, size);
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
    for (const Piece& piece : pieces_of(run.string, utf8)) {
      line.runs.push_back(rasterise(piece.utf8, *piece.font, size * run_size(run.level)));
      line.rises.push_back(static_cast<int>(std::lround(size * run_rise(run.level))));
      line.width += line.runs.back().width;
    }
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
