#pragma once
// The upright bar beside a picture that says which colour stands for which value.

#include "view/frame.hpp"

namespace signorini::view {

struct BarPlace {
  double left, bottom, top; ///< pixels
};

/// Width in pixels from the picture's frame to the end of the bar's title.
double colorbar_room(const std::array<double, 2>& range, const std::string& title, double height, const Style& style);

/// `beyond`: whether values lie below and above the range; the bar then ends in a point there.
void draw_colorbar(Drawing& drawing, const BarPlace& place, const std::array<double, 2>& range,
                   std::array<bool, 2> beyond, const std::vector<Rgb>& colours, const std::string& title,
                   const Style& style);

} // namespace signorini::view
