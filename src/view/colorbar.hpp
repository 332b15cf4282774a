#pragma once
// Color maps by name, color ranges, and the color bar.

#include "base/eigen.hpp"
#include "view/drawing.hpp"
#include "view/frame.hpp"

#include <optional>
#include <string>
#include <vector>

namespace signorini::view {

/// 256 colors, evenly spaced, interpolated from the map's anchors. Throws Error on an unknown name.
std::vector<Rgb> colormap(const std::string& name);

std::vector<std::string> colormaps();

/// True for maps whose middle represents zero.
bool is_diverging(const std::string& name);

/// The values that are colored.
struct ColoredValues {
  std::array<double, 2> all;     ///< minimum and maximum
  std::array<double, 2> typical; ///< the same without outliers, see colored_values()
  std::size_t count = 0, extreme = 0;
  bool clipped() const { return extreme > 0; }
};
/// Over all states, without nan; empty without values. Outliers are the highest (lowest) 0.5 % if they exceed the
/// others by more than three times the range of these: one sample at a singular point would otherwise leave a single
/// color for all others.
std::optional<ColoredValues> colored_values(const std::vector<const VectorX*>& values);

/// The default color range excludes outliers: the warning states their number and extreme values.
std::array<double, 2> color_range(const ColoredValues& values, const std::optional<std::array<double, 2>>& given,
                                  bool diverging, const std::string& title);
/// The given range, or minimum and maximum of the values; symmetric about zero for diverging colors if the values have
/// both signs. A single value, or values that differ by rounding error only, are widened on both sides. Throws Error on
/// a given range that does not ascend.
std::array<double, 2> color_range(const std::array<double, 2>& values,
                                  const std::optional<std::array<double, 2>>& given, bool diverging);

struct BarPlace {
  double left, bottom, top; ///< pixels
};

/// Width in pixels from the picture's frame to the right end of the bar's title.
double colorbar_room(const std::array<double, 2>& range, const std::string& title, double height, const Style& style,
                     bool log = false);

/// `values`: minimum and maximum, printed at the ends of the bar; an end beyond which values lie is pointed. Values
/// that do not differ have a bar of one color without ticks, unless the range is given. `log`: logarithmic colors.
/// `levels`: of contour lines.
void draw_colorbar(Drawing& drawing, const BarPlace& place, const std::array<double, 2>& range,
                   const std::array<double, 2>& values, const std::vector<Rgb>& colors, const std::string& title,
                   const Style& style, bool log = false, const std::vector<double>& levels = {});

} // namespace signorini::view
