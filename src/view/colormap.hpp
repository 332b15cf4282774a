#pragma once
// Colour maps by name.

#include "view/drawing.hpp"

#include <string>
#include <vector>

namespace signorini::view {

/// 256 colours evenly spread over the map, interpolated from its anchors. Throws Error on an unknown name.
std::vector<Rgb> colormap(const std::string& name);

/// True for maps whose middle stands for zero.
bool is_diverging(const std::string& name);

} // namespace signorini::view
