#include "view/camera.hpp"

#include "base/error.hpp"
#include "view/text.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::view {
namespace {

constexpr Rgb axis_colors[] = {{178, 52, 44}, {36, 126, 62}, {40, 84, 164}};

double arm_length(const Style& style) {
  return 2.7 * style.tick_size;
}

/// Arms nearly along the line of sight are drawn as dots without a name.
bool is_seen(const Vec<2>& direction) {
  return direction.norm() > 0.15;
}

/// Center of an axis name, relative to the origin of the arrows; `half`: half the width of the name.
Vec<2> name_at(const Vec<2>& direction, double half, const Style& style) {
  const Vec<2> along = direction.normalized();
  const double letter = 0.28 * style.tick_size;
  return arm_length(style) * direction + 0.55 * style.tick_size * along +
         Vec<2>(std::max(0.0, half - letter) * along[0], 0);
}

} // namespace

Camera camera(const std::string& name) {
  const Vec<3> x = Vec<3>::UnitX(), y = Vec<3>::UnitY(), z = Vec<3>::UnitZ();
  if (name == "iso") return {{0.75, -1.5, 1}, z};
  if (name == "front") return {-y, z};
  if (name == "back") return {y, z};
  if (name == "left") return {-x, z};
  if (name == "right") return {x, z};
  if (name == "top") return {z, y};
  if (name == "bottom") return {-z, -y};
  fail("view.camera.unknown", {{"camera", name}, {"known", camera_names()}});
}

const std::vector<std::string>& camera_names() {
  static const std::vector<std::string> names = {"iso", "front", "back", "left", "right", "top", "bottom"};
  return names;
}

Camera turned_to(Camera camera, const Vec<3>& normal) {
  if (camera.from.dot(normal) > 0.1 * camera.from.norm() * normal.norm()) return camera;
  // from·n = Σ fᵢnᵢ: negative terms change sign
  for (int axis = 0; axis < 3; ++axis)
    if (camera.from[axis] * normal[axis] < 0) camera.from[axis] *= -1;
  return camera;
}

Mat<3> picture_axes(const Camera& camera) {
  require(camera.from.norm() > 0 && camera.up.norm() > 0, "view.camera.zero");
  const Vec<3> eye = camera.from.normalized(), right = camera.up.normalized().cross(eye);
  require(right.norm() > 1e-6, "view.camera.parallel");
  Mat<3> axes;
  axes.row(0) = right.normalized();
  axes.row(2) = eye;
  axes.row(1) = eye.cross(right.normalized());
  return axes;
}

std::array<double, 4> triad_room(const Mat<3>& axes, const std::array<std::string, 3>& names, const Style& style) {
  const double dot = 0.2 * style.tick_size, high = 0.45 * style.tick_size;
  std::array<double, 4> space = {dot, dot, dot, dot};
  for (int axis = 0; axis < 3; ++axis) {
    const Vec<2> direction = axes.col(axis).head<2>();
    if (!is_seen(direction)) continue;
    const double half = 0.5 * text_width(names[axis], style.tick_size);
    const Vec<2> at = name_at(direction, half, style);
    space = {std::max(space[0], std::max(half, high) - at[0]), std::max(space[1], std::max(half, high) + at[0]),
             std::max(space[2], high - at[1]), std::max(space[3], high + at[1])};
  }
  return space;
}

void draw_triad(Drawing& drawing, const Vec2& at, const Mat<3>& axes, const std::array<std::string, 3>& names,
                const Style& style) {
  const Vec<2> origin(at[0], at[1]);
  std::array<int, 3> order = {0, 1, 2}; // those that point away from the eye first
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return axes(2, a) < axes(2, b); });
  for (int axis : order) {
    const Vec<2> direction = axes.col(axis).head<2>();
    if (!is_seen(direction)) continue;
    const double length = arm_length(style) * direction.norm();
    const Vec<2> tip = origin + arm_length(style) * direction;
    draw_arrow(drawing, {at, {tip[0], tip[1]}}, std::min(0.5 * style.tick_size, 0.7 * length), 3.2 * style.unit,
               axis_colors[axis]);
    const Vec<2> middle = origin + name_at(direction, 0.5 * text_width(names[axis], style.tick_size), style);
    // Vertical centering: half the letter height above the baseline.
    drawing.marks.push_back(
        Text{{middle[0], middle[1] - 0.27 * style.tick_size}, names[axis], style.tick_size, Align::center, ink});
  }
  drawing.marks.push_back(Fill{circle_about(at, 4.5 * style.unit), ink});
}

double ruler_room(const Style& style) {
  return 1.5 * style.tick_size;
}

void draw_ruler(Drawing& drawing, const Vec2& at, const Scale& scale, const std::string& unit, const Style& style) {
  const double length = round_below(0.2 * (scale.high - scale.low));
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

double round_below(double value) {
  value *= 1 + 1e-9; // compensates rounding error
  const double decade = std::pow(10, std::floor(std::log10(value)));
  return decade * (value >= 5 * decade ? 5 : value >= 2 * decade ? 2 : 1);
}

} // namespace signorini::view
