#include "view/cairo/parts.hpp"

#include "view/text.hpp"

#include <cctype>
#include <cstdio>
#include <map>

namespace signorini::view {
namespace {

/// Two decimals of a pixel, without trailing zeros.
std::string decimal(double value) {
  char digits[32];
  int length = std::snprintf(digits, sizeof digits, "%.2f", value);
  while (digits[length - 1] == '0') --length;
  if (digits[length - 1] == '.') --length;
  return {digits, digits + length};
}

std::string hex(const Rgb& color) {
  char digits[8];
  std::snprintf(digits, sizeof digits, "#%02x%02x%02x", color[0], color[1], color[2]);
  return digits;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else
      result += c;
  }
  return result;
}

/// An element anchored at x, y; y points downwards in SVG.
std::string element(const Text& text, double along, double down) {
  const std::string x = decimal(along), y = decimal(down);
  std::string out =
      "<text x=\"" + x + "\" y=\"" + y + "\" font-size=\"" + decimal(text.size) + "\" fill=\"" + hex(text.color) + "\"";
  if (text.align != Align::left)
    out += text.align == Align::center ? " text-anchor=\"middle\"" : " text-anchor=\"end\"";
  if (text.upright) out += " transform=\"rotate(-90 " + x + " " + y + ")\"";
  out += ">";
  double rise = 0;
  for (const TextRun& run : text_runs(text.string)) {
    const double next = run_rise(run.level) * text.size;
    if (run.level == 0 && rise == 0) {
      out += escaped(run.string);
      continue;
    }
    out += "<tspan dy=\"" + decimal(rise - next) + "\" font-size=\"" + decimal(run_size(run.level) * text.size) +
           "\">" + escaped(run.string) + "</tspan>";
    rise = next;
  }
  return out + "</text>\n";
}

/// The ids of Cairo, such as surface39, with new numbers in this file.
std::string renumbered(const std::string& svg) {
  std::string result;
  std::map<std::string, std::size_t> numbers;
  const std::string key = "surface";
  for (std::size_t at = 0;;) {
    const std::size_t found = svg.find(key, at), digits = found + key.size();
    result.append(svg, at, found == svg.npos ? svg.npos : digits - at);
    if (found == svg.npos) return result;
    std::size_t end = digits;
    while (end < svg.size() && std::isdigit(static_cast<unsigned char>(svg[end]))) ++end;
    const auto number = numbers.try_emplace(svg.substr(digits, end - digits), numbers.size() + 1).first;
    if (end > digits) result += std::to_string(number->second);
    at = end;
  }
}

} // namespace

std::string searchable(const std::string& svg, const Figure& figure) {
  std::string texts;
  for (const auto& [at, plate] : figure.plates)
    for (const Mark& mark : plate.drawing.marks)
      if (const Text* text = std::get_if<Text>(&mark))
        texts += element(*text, at[0] + text->at[0], figure.size[1] - at[1] - text->at[1]);
  const std::size_t end = svg.rfind("</svg>");
  return renumbered(svg.substr(0, end)) +
         "<g fill-opacity=\"0\" xml:space=\"preserve\" font-family=\"'Liberation Sans', Arial, Helvetica, "
         "sans-serif\">\n" +
         texts + "</g>\n" + svg.substr(end);
}

} // namespace signorini::view
