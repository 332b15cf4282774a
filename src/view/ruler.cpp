#include "view/ruler.hpp"

#include <cmath>

namespace signorini::view {

double ruler_room(const Style& style) {
  return 1.5 * style.tick_size;
}

void draw_ruler(Drawing& drawing, const Vec2& at, const Scale& scale, const std::string& unit, const Style& style) {
  constexpr double share = 0.2; // of the frame's width, at most
  const double most = share * (scale.high - scale.low), decade = std::pow(10, std::floor(std::log10(most)));
  const double length = decade * (most >= 5 * decade ? 5 : most >= 2 * decade ? 2 : 1);
  const double size = style.tick_size, end = at[0] + length * (scale.to - scale.from) / (scale.high - scale.low);
  const double y = at[1] + 0.5 * size, half = 0.25 * size;
  for (const auto& [from, to] : {std::pair{Vec2{at[0], y}, Vec2{end, y}},
                                 {{at[0], y - half}, {at[0], y + half}},
                                 {{end, y - half}, {end, y + half}}})
    drawing.marks.push_back(Stroke{{from, to}, ink, 2.2 * style.unit});
  drawing.marks.push_back(Text{{end + 0.5 * size, y - 0.36 * size},
                               in_digits(length) + (unit.empty() ? "" : " " + unit),
                               size,
                               Align::left,
                               ink});
}

} // namespace signorini::view
