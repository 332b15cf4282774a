#include "view/triad.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace signorini::view {
namespace {

constexpr Rgb colours[] = {{178, 52, 44}, {36, 126, 62}, {40, 84, 164}};
constexpr const char* letters[] = {"x", "y", "z"};

double arm_length(const Style& style) {
  return 2.7 * style.tick_size;
}

/// Arms that point nearly along the line of sight are dots without a letter.
bool drawn(const Vec<2>& direction) {
  return direction.norm() > 0.15;
}

/// The middle of an axis's letter, from where the axes meet.
Vec<2> letter_at(const Vec<2>& direction, const Style& style) {
  return arm_length(style) * direction + 0.55 * style.tick_size * direction.normalized();
}

} // namespace

std::array<double, 4> triad_room(const Mat<3>& axes, const Style& style) {
  const double dot = 0.2 * style.tick_size, letter = 0.45 * style.tick_size;
  std::array<double, 4> room = {dot, dot, dot, dot};
  for (int axis = 0; axis < 3; ++axis) {
    const Vec<2> direction = axes.col(axis).head<2>();
    if (!drawn(direction)) continue;
    const Vec<2> at = letter_at(direction, style);
    for (int i = 0; i < 2; ++i) {
      auto &low = room[static_cast<std::size_t>(2 * i)], &high = room[static_cast<std::size_t>(2 * i + 1)];
      low = std::max(low, letter - at[i]), high = std::max(high, letter + at[i]);
    }
  }
  return room;
}

void draw_triad(Drawing& drawing, const Vec2& at, const Mat<3>& axes, const Style& style) {
  const Vec<2> origin(at[0], at[1]);
  const auto plain = [](const Vec<2>& v) { return Vec2{v[0], v[1]}; };
  std::array<int, 3> order = {0, 1, 2}; // those that point away first
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return axes(2, a) < axes(2, b); });
  for (int axis : order) {
    const Rgb& colour = colours[axis];
    const Vec<2> direction = axes.col(axis).head<2>();
    if (!drawn(direction)) continue;
    const Vec<2> along = direction.normalized(), side(-along[1], along[0]);
    const double length = arm_length(style) * direction.norm(), head = std::min(0.5 * style.tick_size, 0.7 * length);
    const Vec<2> tip = origin + length * along, neck = tip - head * along;
    drawing.marks.push_back(Stroke{{at, plain(neck)}, colour, 3.2 * style.unit});
    drawing.marks.push_back(
        Fill{{plain(tip), plain(neck + 0.38 * head * side), plain(neck - 0.38 * head * side)}, colour});
    const Vec<2> middle = origin + letter_at(direction, style);
    // The letters' height above the baseline is half of their size.
    drawing.marks.push_back(
        Text{{middle[0], middle[1] - 0.27 * style.tick_size}, letters[axis], style.tick_size, Align::centre, ink});
  }
  std::vector<Vec2> dot;
  for (int k = 0; k < 24; ++k) {
    const double angle = k * std::numbers::pi / 12;
    dot.push_back(plain(origin + 4.5 * style.unit * Vec<2>(std::cos(angle), std::sin(angle))));
  }
  drawing.marks.push_back(Fill{dot, ink});
}

} // namespace signorini::view
