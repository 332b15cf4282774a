#include "view/cell_axes.hpp"

#include "base/error.hpp"
#include "view/text.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace signorini::view {
namespace {

constexpr Rgb tick_colour = {70, 70, 70};
constexpr double least = 0.7;         // of the size of numbers: the smallest that names shrink to before some go
constexpr double legible = 5;         // pixels
constexpr double digit_height = 0.72; // in the font's size

double widest(const std::vector<std::string>& names) {
  double width = 0;
  for (const std::string& name : names) width = std::max(width, text_width(name, 1));
  return width;
}

double gap(const Style& style) {
  return 0.4 * style.tick_size;
}

/// The size at which the longest name is no longer than `room`.
double size_within(double wanted, double longest, double room, char axis) {
  const double size = longest > 0 ? std::min(wanted, room / longest) : wanted;
  require(size >= legible, "the names along the ", axis,
          " axis are too long for the map; choose shorter ones or a larger ", "size");
  return size;
}

/// Each how manieth has to be written where one needs `needed` pixels.
std::size_t stride_for(double needed, double step) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(needed / step - 1e-9)));
}

/// Of numbers some can be left out: readers know those between.
bool is_number(const std::string& name) {
  return std::none_of(name.begin(), name.end(), [](unsigned char c) { return std::isalpha(c) != 0; });
}

/// The middle of the cell.
double middle(double from, double to, std::size_t cell, std::size_t count) {
  return from + (to - from) * (cell + 0.5) / count;
}

} // namespace

CellNames names_below(const std::vector<std::string>& names, double width, double most, const Style& style) {
  CellNames result{names};
  const double longest = widest(names), full = style.tick_size;
  // Beside each other, a little smaller where that is enough.
  const double fit = width / (longest + 0.6);
  const bool numbers = std::all_of(names.begin(), names.end(), is_number);
  if (fit >= least * full || numbers) {
    result.size = std::clamp(fit, least * full, full);
    result.stride = stride_for((longest + 0.6) * result.size, width);
    result.room = 1.6 * full;
    return result;
  }
  result.upright = true;
  result.size = size_within(std::clamp(width / 1.15, least * full, full), longest, most - gap(style), 'x');
  result.stride = stride_for(1.15 * result.size, width);
  result.room = longest * result.size + gap(style);
  return result;
}

CellNames names_beside(const std::vector<std::string>& names, double height, double most, const Style& style) {
  CellNames result{names};
  const double full = style.tick_size;
  const double air = 1.5 * gap(style);
  result.size = size_within(std::clamp(height / 1.15, least * full, full), widest(names), most - air, 'y');
  result.stride = stride_for(1.15 * result.size, height);
  result.room = widest(names) * result.size + air;
  return result;
}

void draw_names_below(Drawing& drawing, const CellNames& names, const Box& box, const Style& style) {
  const std::size_t count = names.names.size();
  for (std::size_t i = 0; i < count; i += names.stride) {
    const double x = middle(box[0], box[1], i, count);
    if (names.stride > 1)
      drawing.marks.push_back(Stroke{{{x, box[2]}, {x, box[2] - 0.5 * gap(style)}}, tick_colour, 1.6 * style.unit});
    const Vec2 at = names.upright ? Vec2{x + 0.5 * digit_height * names.size, box[2] - gap(style)}
                                  : Vec2{x, box[2] - gap(style) - 0.85 * names.size};
    drawing.marks.push_back(
        Text{at, names.names[i], names.size, names.upright ? Align::right : Align::centre, ink, names.upright});
  }
}

void draw_names_beside(Drawing& drawing, const CellNames& names, const Box& box, const Style& style) {
  const std::size_t count = names.names.size();
  for (std::size_t i = 0; i < count; i += names.stride) {
    const double y = middle(box[2], box[3], i, count);
    if (names.stride > 1)
      drawing.marks.push_back(Stroke{{{box[0], y}, {box[0] - 0.5 * gap(style), y}}, tick_colour, 1.6 * style.unit});
    drawing.marks.push_back(Text{
        {box[0] - gap(style), y - 0.5 * digit_height * names.size}, names.names[i], names.size, Align::right, ink});
  }
}

} // namespace signorini::view
