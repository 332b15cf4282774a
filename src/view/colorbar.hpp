#pragma once
// Color maps by name, the range that they are spread over, and the bar that shows both.

#include "base/eigen.hpp"
#include "view/drawing.hpp"
#include "view/frame.hpp"

#include <optional>
#include <string>
#include <vector>

namespace signorini::view {

/// 256 colors evenly spread over the map, interpolated from its anchors. Throws Error on an unknown name.
std::vector<Rgb> colormap(const std::string& name);

std::vector<std::string> colormaps(); ///< their names

/// True for maps whose middle stands for zero.
bool is_diverging(const std::string& name);

/// The values that colors stand for.
struct ColoredValues {
  std::array<double, 2> all;     ///< lowest and highest
  std::array<double, 2> typical; ///< the same without the extreme samples, see colored_values()
  std::size_t count = 0, extreme = 0;
  bool clipped() const { return extreme > 0; }
};
/// Of all states; nothing without values. Extreme are the highest 0.5 % (and the lowest) where they lie farther beyond
/// the rest than three times its range: one sample in a singular point would leave a single color for all others.
std::optional<ColoredValues> colored_values(const std::vector<const VectorX*>& values);

/// The range of the colors where none is given leaves extreme samples out: a warning says how many, and how far they
/// reach.
std::array<double, 2> color_range(const ColoredValues& values, const std::optional<std::array<double, 2>>& given,
                                  bool diverging, const std::string& title);
/// The given range, or the values' own, lowest and highest; about zero for diverging colors where the values have both
/// signs. A single value, or values that only rounding tells apart, get room on both sides.
/// Throws Error on a given range that does not rise.
std::array<double, 2> color_range(const std::array<double, 2>& values,
                                  const std::optional<std::array<double, 2>>& given, bool diverging);

struct BarPlace {
  double left, bottom, top; ///< pixels
};

/// Width in pixels from the picture's frame to the end of the bar's title.
double colorbar_room(const std::array<double, 2>& range, const std::string& title, double height, const Style& style,
                     bool log = false);

/// `values`: the lowest and the highest, which are printed at the bar's ends; where they lie beyond the range, the bar
/// ends in a point. `log`: the colors follow the values' logarithm. `levels`: of contour lines.
void draw_colorbar(Drawing& drawing, const BarPlace& place, const std::array<double, 2>& range,
                   const std::array<double, 2>& values, const std::vector<Rgb>& colors, const std::string& title,
                   const Style& style, bool log = false, const std::vector<double>& levels = {});

} // namespace signorini::view
