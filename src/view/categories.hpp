#pragma once
// How the cells of a map look: colors that are told apart by color-blind readers and in gray, and hatching.

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

/// Light green and blue, for outcomes that are wanted.
const std::vector<Look>& good_looks();
/// 21 warm and dark ones, for those that are not. The plain ones come first; they differ in lightness by steps of about
/// ten hundredths of the way from black to white, so that they stay apart without color.
const std::vector<Look>& bad_looks();

/// CIE L*: 0 for black, 100 for white; even steps look even.
double lightness(const Rgb& color);
/// Black or white, whichever reads better on the color.
Rgb text_color(const Rgb& ground);

void fill_cell(Drawing& drawing, const Box& box, const Look& look, const Style& style);

} // namespace signorini::view
