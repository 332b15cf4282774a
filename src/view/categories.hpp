#pragma once
// Fills of the cells of a map: hatching and colors that color-blind readers and gray prints distinguish.

#include "view/frame.hpp"

namespace signorini::view {

enum class Hatch { none, rising, crossed };

struct Look {
  Rgb color;
  Hatch hatch = Hatch::none;

  bool operator==(const Look&) const = default;
};

struct Category {
  std::string name;
  Look look;
};

/// Light green and blue, for favorable outcomes.
const std::vector<Look>& good_looks();
/// 21 warm and dark fills, for unfavorable outcomes. Those without hatching come first; their lightness differs by
/// steps of about 10 % of the range from black to white, so that they differ without color.
const std::vector<Look>& bad_looks();

/// CIE L*: 0 for black, 100 for white; perceptually uniform.
double lightness(const Rgb& color);
/// Black or white, whichever has the greater contrast with the color.
Rgb text_color(const Rgb& background);

void fill_cell(Drawing& drawing, const Box& box, const Look& look, const Style& style);

} // namespace signorini::view
