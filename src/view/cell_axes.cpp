#include "view/cell_axes.hpp"

#include "view/text.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace signorini::view {
namespace {

constexpr Rgb tick_colour = {70, 70, 70};
constexpr double least = 0.7;        // of the size of numbers: the smallest that names shrink to before some go
constexpr double row = 1.15;         // from one line to the next at the least, in its size
constexpr double name_height = 0.72; // in the font's size

double widest(const std::vector<std::string>& names) {
  double width = 0;
  for (const std::string& name : names) width = std::max(width, text_width(name, 1));
  return width;
}

double gap(const Style& style) {
  return 0.4 * style.tick_size;
}

/// Each how manieth has to be written where one needs `needed` pixels.
std::size_t stride_for(double needed, double step) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(needed / step - 1e-9)));
}

/// Of numbers some can be left out: readers know those between.
bool is_number(const std::string& name) {
  return std::none_of(name.begin(), name.end(), [](unsigned char c) { return std::isalpha(c) != 0; });
}

double widest(const std::vector<FittedText>& names) {
  double width = 0;
  for (const FittedText& name : names) width = std::max(width, name.width());
  return width;
}

std::vector<FittedText> fit_all(const std::vector<std::string>& names, double size, double room, int lines,
                                const Style& style) {
  std::vector<FittedText> fitted;
  for (const std::string& name : names)
    fitted.push_back(fit_text(name, size, std::min(size, least_size(style)), room, lines));
  return fitted;
}

CellNames upright(const std::vector<std::string>& names, double width, double most, const Style& style) {
  CellNames result;
  result.upright = true;
  result.size = std::clamp(width / row, least * style.tick_size, style.tick_size);
  result.stride = stride_for(row * result.size, width);
  const int lines = std::clamp(static_cast<int>(width / (line_step * result.size) - 0.3), 1, 3);
  result.names = fit_all(names, result.size, most - gap(style), result.stride > 1 ? 1 : lines, style);
  result.room = widest(result.names) + gap(style);
  return result;
}

/// The middle of the cell.
double middle(double from, double to, std::size_t cell, std::size_t count) {
  return from + (to - from) * (cell + 0.5) / count;
}

} // namespace

CellNames names_below(const std::vector<std::string>& names, double width, double most, const Style& style) {
  CellNames result;
  const double longest = widest(names), full = style.tick_size;
  // Beside each other, a little smaller where that is enough.
  const double fit = width / (longest + 0.6);
  const bool numbers = std::all_of(names.begin(), names.end(), is_number);
  if (fit >= least * full || numbers) {
    result.size = std::clamp(fit, least * full, full);
    for (const std::string& name : names) result.names.push_back({{name}, result.size});
    result.stride = stride_for((longest + 0.6) * result.size, width);
    result.room = 1.6 * full;
    return result;
  }
  double depth = 0;
  const double beside = width - 0.6 * least_size(style);
  for (const std::string& name : names) {
    result.names.push_back(fit_text(name, full, least_size(style), beside, 3));
    depth = std::max(depth, result.names.back().depth());
    result.size = std::max(result.size, result.names.back().size);
  }
  result.room = 1.6 * full + depth;
  const auto cut = [](const FittedText& name) { return name.cut; };
  if (result.room <= most && std::none_of(result.names.begin(), result.names.end(), cut)) return result;
  return upright(names, width, most, style);
}

CellNames names_beside(const std::vector<std::string>& names, double height, double most, const Style& style) {
  CellNames result;
  const double full = style.tick_size, air = 1.5 * gap(style);
  result.size = std::clamp(height / row, least * full, full);
  result.stride = stride_for(row * result.size, height);
  const int lines = std::clamp(static_cast<int>(height / (line_step * result.size) - 0.3), 1, 3);
  result.names = fit_all(names, result.size, most - air, result.stride > 1 ? 1 : lines, style);
  result.room = widest(result.names) + air;
  return result;
}

void draw_names_below(Drawing& drawing, const CellNames& names, const Box& box, const Style& style) {
  const std::size_t count = names.names.size();
  for (std::size_t i = 0; i < count; i += names.stride) {
    const FittedText& name = names.names[i];
    const double x = middle(box[0], box[1], i, count);
    if (names.stride > 1)
      drawing.marks.push_back(Stroke{{{x, box[2]}, {x, box[2] - 0.5 * gap(style)}}, tick_colour, 1.6 * style.unit});
    Vec2 at = names.upright ? Vec2{x + 0.5 * (name_height * name.size - name.depth()), box[2] - gap(style)}
                            : Vec2{x, box[2] - gap(style) - 0.85 * names.size};
    for (const std::string& line : name.lines) {
      drawing.marks.push_back(
          Text{at, line, name.size, names.upright ? Align::right : Align::centre, ink, names.upright});
      at[names.upright ? 0 : 1] += (names.upright ? 1 : -1) * line_step * name.size;
    }
  }
}

void draw_names_beside(Drawing& drawing, const CellNames& names, const Box& box, const Style& style) {
  const std::size_t count = names.names.size();
  for (std::size_t i = 0; i < count; i += names.stride) {
    const FittedText& name = names.names[i];
    const double y = middle(box[2], box[3], i, count);
    if (names.stride > 1)
      drawing.marks.push_back(Stroke{{{box[0], y}, {box[0] - 0.5 * gap(style), y}}, tick_colour, 1.6 * style.unit});
    double base = y + 0.5 * (name.depth() - name_height * name.size);
    for (const std::string& line : name.lines) {
      drawing.marks.push_back(Text{{box[0] - gap(style), base}, line, name.size, Align::right, ink});
      base -= line_step * name.size;
    }
  }
}

} // namespace signorini::view
