#include "view/categories.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::view {
namespace {

constexpr Rgb light_green = {205, 235, 228}, light_blue = {143, 208, 214};
// Ordered so that neighbors differ strongly: lightness 62, 21, 50, 72, 8, 42, 29.
constexpr Rgb orange = {224, 123, 39}, purple = {67, 36, 100}, red = {204, 75, 60}, gold = {226, 167, 43},
              soot = {29, 22, 22}, magenta = {169, 53, 119}, wine = {126, 33, 53};

std::vector<Look> each_hatched(const std::vector<Rgb>& colors) {
  std::vector<Look> looks;
  for (Hatch hatch : {Hatch::none, Hatch::rising, Hatch::crossed})
    for (const Rgb& color : colors) looks.push_back({color, hatch});
  return looks;
}

/// CIE Y of sRGB (IEC 61966-2-1), from 0 to 1.
double luminance(const Rgb& color) {
  const auto linear = [](std::uint8_t channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
}

/// Color of hatch lines: lighter on dark colors, darker on light ones.
Rgb line_color(const Rgb& background) {
  const bool light = lightness(background) > 55;
  Rgb result;
  for (std::size_t c = 0; c < 3; ++c)
    result[c] = static_cast<std::uint8_t>(light ? 0.5 * background[c] : background[c] + 0.55 * (255 - background[c]));
  return result;
}

} // namespace

const std::vector<Look>& good_looks() {
  static const std::vector<Look> looks = each_hatched({light_green, light_blue});
  return looks;
}

const std::vector<Look>& bad_looks() {
  static const std::vector<Look> looks = each_hatched({orange, purple, red, gold, soot, magenta, wine});
  return looks;
}

double lightness(const Rgb& color) {
  const double y = luminance(color);
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

Rgb text_color(const Rgb& background) {
  // The contrast ratios (Y₁ + 0.05) / (Y₂ + 0.05) with white and with black are equal at Y = 0.179 (WCAG 2.1, 1.4.3).
  return luminance(background) > 0.179 ? black : white;
}

void fill_cell(Drawing& drawing, const Box& box, const Look& look, const Style& style) {
  fill_box(drawing, box, look.color);
  if (look.hatch == Hatch::none) return;
  const auto& [left, right, bottom, top] = box;
  const double width = right - left, height = top - bottom;
  const double step = std::clamp(std::min(width, height) / 2, 3 * style.unit, 16 * style.unit);
  const Rgb color = line_color(look.color);
  const auto draw = [&](const std::vector<Vec2>& line) {
    for (auto& part : clip_line(line, box)) drawing.marks.push_back(Stroke{std::move(part), color, 0.16 * step});
  };
  for (int k = 0; (k + 0.5) * step < width + height; ++k) {
    const double at = (k + 0.5) * step;
    draw({{left + at - height, bottom}, {left + at, top}});
    if (look.hatch == Hatch::crossed) draw({{left + at, bottom}, {left + at - height, top}});
  }
}

} // namespace signorini::view
