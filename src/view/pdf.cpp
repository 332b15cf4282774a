// The PDF writer: one page, an uncompressed content stream, the three standard fonts that every viewer brings along.

#include "base/error.hpp"
#include "base/warning.hpp"
#include "view/output.hpp"
#include "view/text.hpp"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <optional>

namespace signorini::view {
namespace {

constexpr double points_per_pixel = 0.45; // 1600 pixels become 10 inches

/// PDF 32000-1:2008, annex D.2: WinAnsi from 0x80; 0 where it has no character.
constexpr char32_t winansi_from_80[32] = {U'€', 0,    U'‚', U'ƒ', U'„', U'…', U'†', U'‡', U'ˆ', U'‰', U'Š',
                                          U'‹', U'Œ', 0,    U'Ž', 0,    0,    U'‘', U'’', U'“', U'”', U'•',
                                          U'–', U'—', U'˜', U'™', U'š', U'›', U'œ', 0,    U'ž', U'Ÿ'};

/// Annex D.5: Symbol's Greek letters in Unicode's order, from U+0391 and U+03B1 (U+03A2 is not a letter).
constexpr char symbol_capitals[] = "ABGDEZHQIKLMNXOPR STUFCYW";
constexpr char symbol_letters[] = "abgdezhqiklmnxoprVstufcyw";

struct SymbolSign {
  char32_t point;
  unsigned char byte;
};
constexpr SymbolSign symbol_signs[] = {
    {U'≤', 0xA3}, {U'∞', 0xA5}, {U'→', 0xAE}, {U'≥', 0xB3}, {U'∂', 0xB6}, {U'≠', 0xB9}, {U'≈', 0xBB}, {U'∇', 0xD1},
    {U'√', 0xD6}, {U'∆', 0x44}, {U'∑', 0xE5}, {U'∫', 0xF2}, {U'←', 0xAC}, {U'ϕ', 0x6A}, {U'∝', 0xB5},
};

/// A byte and the font that draws it: 1 Helvetica, 2 Symbol, 3 Zapf Dingbats.
struct Glyph {
  unsigned char byte;
  int font;
};

std::optional<Glyph> find_glyph(char32_t p) {
  if (p == U'−') p = U'–'; // Helvetica's dash looks the same; Symbol's minus is missing where viewers replace that font
  if ((p >= 0x20 && p <= 0x7E) || (p >= 0xA0 && p <= 0xFF)) return Glyph{static_cast<unsigned char>(p), 1};
  const auto* ansi = std::find(std::begin(winansi_from_80), std::end(winansi_from_80), p);
  if (p != 0 && ansi != std::end(winansi_from_80))
    return Glyph{static_cast<unsigned char>(0x80 + (ansi - winansi_from_80)), 1};
  if (p >= U'Α' && p <= U'Ω' && p != 0x3A2) return Glyph{static_cast<unsigned char>(symbol_capitals[p - U'Α']), 2};
  if (p >= U'α' && p <= U'ω') return Glyph{static_cast<unsigned char>(symbol_letters[p - U'α']), 2};
  for (const SymbolSign& sign : symbol_signs)
    if (sign.point == p) return Glyph{sign.byte, 2};
  return std::nullopt;
}

constexpr Glyph box = {0x6F, 3}; // in the place of what no font has

std::string pdf_number(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.2f", value);
  return digits;
}

std::string pdf_point(const Vec2& p) {
  return pdf_number(p[0]) + " " + pdf_number(p[1]);
}

std::string colour(const Rgb& c, const char* verb) {
  char digits[48];
  std::snprintf(digits, sizeof digits, "%.3f %.3f %.3f %s\n", c[0] / 255.0, c[1] / 255.0, c[2] / 255.0, verb);
  return digits;
}

/// Says which characters the fonts lack.
void warn_of(const std::string& missing, const std::string& whole) {
  if (!missing.empty())
    warn(text("a PDF's standard fonts cannot show ", missing, " of the text '", whole,
              "': boxes stand in the place; write .svg or .png, or use other words"));
}

/// Shows a run's characters, changing fonts where needed; names those that the fonts lack.
std::string show(const TextRun& run, double size, std::string& missing) {
  std::string out;
  int font = 0;
  for (char32_t p : code_points(run.string)) {
    const auto found = find_glyph(p);
    if (!found && p != 0xFFFD) missing += (missing.empty() ? "'" : ", '") + to_utf8(p) + "'";
    const Glyph glyph = found.value_or(box);
    if (glyph.font != font) {
      if (font != 0) out += "> Tj\n";
      font = glyph.font;
      out += "/F" + std::to_string(font) + " " + pdf_number(size * run_size(run.level)) + " Tf <";
    }
    char digits[4];
    std::snprintf(digits, sizeof digits, "%02x", glyph.byte);
    out += digits;
  }
  return out + (font != 0 ? "> Tj\n" : "");
}

struct PdfWriter {
  std::string& out;

  std::string path(const std::vector<Vec2>& line) const {
    std::string result;
    for (const Vec2& p : line) result += pdf_point(p) + (result.empty() ? " m\n" : " l\n");
    return result;
  }

  void operator()(const Stroke& stroke) const {
    std::string pattern;
    for (double length : stroke.dash) pattern += pdf_number(length) + " ";
    out += colour(stroke.colour, "RG") + pdf_number(stroke.width) + " w [" + pattern + "] 0 d\n" + path(stroke.points) +
           "S\n";
  }

  void operator()(const Fill& fill) const { out += colour(fill.colour, "rg") + path(fill.outline) + "f\n"; }

  void operator()(const Text& text) const {
    warn_of_broken(text.string);
    const double shift =
        text.align == Align::left ? 0 : text_width(text.string, text.size) * (text.align == Align::centre ? 0.5 : 1);
    const Vec2 start = text.upright ? Vec2{text.at[0], text.at[1] - shift} : Vec2{text.at[0] - shift, text.at[1]};
    out += "BT\n" + colour(text.colour, "rg") + (text.upright ? "0 1 -1 0 " : "1 0 0 1 ") + pdf_point(start) + " Tm\n";
    std::string missing;
    for (const TextRun& run : text_runs(text.string))
      out += pdf_number(run_rise(run.level) * text.size) + " Ts\n" + show(run, text.size, missing);
    out += "ET\n";
    warn_of(missing, text.string);
  }
};

} // namespace

std::string pdf(const Drawing& drawing) {
  std::string content = pdf_number(points_per_pixel) + " 0 0 " + pdf_number(points_per_pixel) + " 0 0 cm 1 j\n";
  for (const Mark& mark : drawing.marks) std::visit(PdfWriter{content}, mark);

  const Vec2 page = {drawing.size[0] * points_per_pixel, drawing.size[1] * points_per_pixel};
  const std::string objects[] = {
      "<< /Type /Catalog /Pages 2 0 R >>",
      "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
      "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 " + pdf_point(page) +
          "] /Contents 4 0 R /Resources << /Font << /F1 5 0 R /F2 6 0 R /F3 7 0 R >> >> >>",
      "<< /Length " + std::to_string(content.size()) + " >>\nstream\n" + content + "endstream",
      "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>",
      "<< /Type /Font /Subtype /Type1 /BaseFont /Symbol >>",
      "<< /Type /Font /Subtype /Type1 /BaseFont /ZapfDingbats >>",
  };
  std::string file = "%PDF-1.4\n", table = "0000000000 65535 f \n";
  int count = 1;
  for (const std::string& object : objects) {
    char entry[24];
    std::snprintf(entry, sizeof entry, "%010zu 00000 n \n", file.size());
    table += entry;
    file += std::to_string(count++) + " 0 obj\n" + object + "\nendobj\n";
  }
  const std::string size = std::to_string(count);
  return file + "xref\n0 " + size + "\n" + table + "trailer\n<< /Size " + size + " /Root 1 0 R >>\nstartxref\n" +
         std::to_string(file.size()) + "\n%%EOF\n";
}

} // namespace signorini::view
