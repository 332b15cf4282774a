#pragma once
// Three small arrows that show which way the axes x, y, z point.

#include "view/frame.hpp"

#include "base/eigen.hpp"

namespace signorini::view {

/// left, right, below, above: pixels that the arrows and their letters take from where the axes meet. `axes`: the
/// picture's own as rows.
std::array<double, 4> triad_room(const Mat<3>& axes, const Style& style);

void draw_triad(Drawing& drawing, const Vec2& at, const Mat<3>& axes, const Style& style);

} // namespace signorini::view
