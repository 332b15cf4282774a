#pragma once
// What tells directions and lengths in pictures of solids, which have no numbers along axes: three arrows and a ruler.

#include "base/eigen.hpp"
#include "view/frame.hpp"

namespace signorini::view {

/// Pixels that the arrows and their names take left, right, below and above of where the axes meet. `axes`: the
/// picture's own, as rows.
std::array<double, 4> triad_room(const Mat<3>& axes, const std::array<std::string, 3>& names, const Style& style);

void draw_triad(Drawing& drawing, const Vec2& at, const Mat<3>& axes, const std::array<std::string, 3>& names,
                const Style& style);

/// Pixels that a ruler takes of the height.
double ruler_room(const Style& style);

/// Draws a line of a round length, about a fifth of the frame's width, with its length and unit at its end. `at`: its
/// start at the bottom left.
void draw_ruler(Drawing& drawing, const Vec2& at, const Scale& scale, const std::string& unit, const Style& style);

/// The greatest 1, 2 or 5 × 10ᵏ that is no more than a positive value.
double round_below(double value);

} // namespace signorini::view
