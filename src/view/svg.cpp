#include "view/output.hpp"
#include "view/text.hpp"

#include <cstdio>

namespace signorini::view {
namespace {

/// Two decimals of a pixel are enough, and the shortest form keeps files small.
std::string svg_number(double value) {
  char digits[32];
  int length = std::snprintf(digits, sizeof digits, "%.2f", value);
  while (digits[length - 1] == '0') --length;
  if (digits[length - 1] == '.') --length;
  return {digits, digits + length};
}

std::string hex(const Rgb& colour) {
  char digits[8];
  std::snprintf(digits, sizeof digits, "#%02x%02x%02x", colour[0], colour[1], colour[2]);
  return digits;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (char c : text) switch (c) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    default:
      result += c;
    }
  return result;
}

/// Writes marks; SVG's y points downwards.
struct SvgWriter {
  int height;
  std::string& out;

  std::string points(const std::vector<Vec2>& line) const {
    std::string result;
    for (const Vec2& p : line) {
      if (!result.empty()) result += ' ';
      result.append(svg_number(p[0])).append(",").append(svg_number(height - p[1]));
    }
    return result;
  }

  void operator()(const Stroke& stroke) const {
    out += "<polyline points=\"" + points(stroke.points) + "\" fill=\"none\" stroke=\"" + hex(stroke.colour) +
           "\" stroke-width=\"" + svg_number(stroke.width) + "\" stroke-linejoin=\"round\"";
    std::string pattern;
    for (double length : stroke.dash) pattern.append(svg_number(length)).append(" ");
    if (!pattern.empty()) out += " stroke-dasharray=\"" + pattern + "\"";
    out += "/>\n";
  }

  void operator()(const Fill& fill) const {
    out += "<polygon points=\"" + points(fill.outline) + "\" fill=\"" + hex(fill.colour) + "\"/>\n";
  }

  void operator()(const Text& text) const {
    warn_of_broken(text.string);
    const std::string x = svg_number(text.at[0]), y = svg_number(height - text.at[1]);
    out += "<text x=\"" + x + "\" y=\"" + y + "\" font-size=\"" + svg_number(text.size) + "\" fill=\"" +
           hex(text.colour) + "\"";
    if (text.align != Align::left)
      out += text.align == Align::centre ? " text-anchor=\"middle\"" : " text-anchor=\"end\"";
    if (text.upright) out += " transform=\"rotate(-90 " + x + " " + y + ")\"";
    out += ">";
    double rise = 0;
    for (const TextRun& run : text_runs(text.string)) {
      const double next = run_rise(run.level) * text.size;
      if (run.level == 0 && rise == 0) {
        out += escaped(run.string);
        continue;
      }
      out += "<tspan dy=\"" + svg_number(rise - next) + "\" font-size=\"" +
             svg_number(run_size(run.level) * text.size) + "\">" + escaped(run.string) + "</tspan>";
      rise = next;
    }
    out += "</text>\n";
  }
};

} // namespace

std::string svg(const Drawing& drawing) {
  const std::string width = std::to_string(drawing.size[0]), height = std::to_string(drawing.size[1]);
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
                    "xml:space=\"preserve\" width=\"" +
                    width + "\" height=\"" + height + "\" viewBox=\"0 0 " + width + " " + height +
                    "\" font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\">\n<rect width=\"" + width +
                    "\" height=\"" + height + "\" fill=\"#ffffff\"/>\n";
  for (const Mark& mark : drawing.marks) std::visit(SvgWriter{drawing.size[1], out}, mark);
  return out + "</svg>\n";
}

} // namespace signorini::view
