#pragma once
// The upright bar beside a picture that says which colour stands for which value.

#include "view/frame.hpp"

#include <optional>

namespace signorini::view {

/// The given range, or the values' own, lowest and highest; about zero for diverging colours where the values have both
/// signs. A single value, or values that only rounding tells apart, get room on both sides.
/// Throws Error on a given range that does not rise.
std::array<double, 2> colour_range(const std::array<double, 2>& values,
                                   const std::optional<std::array<double, 2>>& given, bool diverging);

struct BarPlace {
  double left, bottom, top; ///< pixels
};

/// Width in pixels from the picture's frame to the end of the bar's title.
double colorbar_room(const std::array<double, 2>& range, const std::string& title, double height, const Style& style,
                     bool log = false);

/// `beyond`: whether values lie below and above the range; the bar then ends in a point there. `log`: the colours
/// follow the values' logarithm.
void draw_colorbar(Drawing& drawing, const BarPlace& place, const std::array<double, 2>& range,
                   std::array<bool, 2> beyond, const std::vector<Rgb>& colours, const std::string& title,
                   const Style& style, bool log = false);

} // namespace signorini::view
